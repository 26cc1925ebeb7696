#pragma once

#include <string>

#include "onnx.pb.h"

namespace place_recognition {

/// Throws Error, a phrase that names no source, unless the length of every tensor matches its
/// shape, every layer uses only what precedes it, no size is out of range, and no layer contains a
/// graph of its own or refers to another file. OpenCV's reader relies on all of this.
void checkGraph(const onnx::Graph& graph);

/// Describes a layer for a person, such as "'conv1' (Conv)".
std::string describe(const onnx::Node& node);

}  // namespace place_recognition
