#pragma once

#include <vector>

#include "place_recognition/model.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// What each cue of a trained model says to samples that it was not trained on. `features`:
/// [cue][sample], of which some may be missing.
std::vector<HeldOutValues> modelAnswers(const Model& model,
                                        const std::vector<std::vector<Feature>>& features);

}  // namespace place_recognition
