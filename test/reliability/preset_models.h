#pragma once

#include <string>
#include <vector>

#include "place_recognition/training_options.h"

namespace place_recognition {

/// The options of every preset in config/, in the order of their names.
std::vector<TrainingOptions> presets();

/// A model of every preset, trained on a few drawn rooms, as the bytes of its file.
const std::vector<std::string>& presetModels();

}  // namespace place_recognition
