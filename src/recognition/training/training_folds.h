#pragma once

#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// The folds of a training: blocks of time, which are trained on and tested in every available
/// light. Sets their length and gap in `options` unless they were given. `threads`: 0 means one per
/// core.
std::vector<Fold> chooseFolds(const Samples& samples, unsigned threads, TrainingOptions& options);

/// `folds` with the first samples, which are `remembered`, trained on in every fold and tested in
/// none.
std::vector<Fold> withRemembered(std::vector<Fold> folds, std::size_t remembered);

}  // namespace place_recognition
