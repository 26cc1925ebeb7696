#pragma once

#include <cstddef>

#include "place_recognition/training.h"

namespace place_recognition {

/// The first views as a recording.
RecordingOpener viewRun(std::size_t count);

/// A model of the cues of `options`, trained on `count` views; each view is a support vector of
/// each cue, because the price of errors is so low.
Model sampleModel(TrainingOptions options, std::size_t count);

/// The same with the cue of the preset `crfh`.
Model sampleModel(std::size_t count);

}  // namespace place_recognition
