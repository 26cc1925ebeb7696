#pragma once

#include <string>

#include "place_recognition/model.h"

namespace place_recognition {

/// Whether a model was trained on the run `input`, in whatever way its path is written. Relative
/// paths start at the current folder.
bool isTrainedOn(const Provenance& provenance, const std::string& input);

}  // namespace place_recognition
