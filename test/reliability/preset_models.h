#pragma once

#include <string>
#include <vector>

#include "place_recognition/recording.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// The options of every preset in config/, in the order of their names;
/// a network that one asks for is a small one.
std::vector<TrainingOptions> presets();

/// A model of every preset, trained on `frames`, as the bytes of its file.
std::vector<std::string> trainPresets(const std::vector<Frame>& frames);

/// The same of a few drawn rooms; trained once.
const std::vector<std::string>& presetModels();

}  // namespace place_recognition
