#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "place_recognition/model.h"
#include "tool/output.h"

namespace place_recognition::tool {

/// Describes a model for a person. `path`, `bytes`: its file and the file's size.
void printModel(const Model& model, const std::string& path, std::uint64_t bytes,
                std::ostream& out);

/// The same for a program.
Json modelFigures(const Model& model, const std::string& path, std::uint64_t bytes);

}  // namespace place_recognition::tool
