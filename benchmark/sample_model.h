#pragma once

#include <cstddef>

#include "place_recognition/training.h"

namespace place_recognition {

/// A recording of the first views.
RecordingOpener viewRun(std::size_t count);

/// A model with the cues of `options`, trained on `count` views. C is so low that each view becomes
/// a support vector of each cue.
Model sampleModel(TrainingOptions options, std::size_t count);

/// The same with the preset `crfh`.
Model sampleModel(std::size_t count);

}  // namespace place_recognition
