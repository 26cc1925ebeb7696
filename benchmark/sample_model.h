#pragma once

#include <cstddef>

#include "place_recognition/training.h"

namespace place_recognition {

/// The first views as a recording.
RecordingOpener viewRun(std::size_t count);

/// A model of the preset `crfh`, but trained at a price of errors so low that every one of `count`
/// views is a support vector.
Model sampleModel(std::size_t count);

}  // namespace place_recognition
