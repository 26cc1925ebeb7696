#pragma once

#include <string>
#include <vector>

#include "place_recognition/recording.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// Returns the options of every preset in config/, in the order of their names, and those of `crfh`
/// with each other kernel of histograms and with one-against-one. A small network replaces any
/// network.
std::vector<TrainingOptions> presets();

/// Trains a model with each of them on `frames` and returns the bytes of its file.
std::vector<std::string> trainPresets(const std::vector<Frame>& frames);

/// The same models for a few drawn rooms; trained once.
const std::vector<std::string>& presetModels();

}  // namespace place_recognition
