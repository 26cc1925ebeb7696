#pragma once

#include <vector>

#include "place_recognition/model.h"
#include "recognition/training/held_out_values.h"

namespace place_recognition {

/// The answers of each cue of a trained model to samples that it was not trained on. `features`:
/// [cue][sample]; some may be missing.
std::vector<HeldOutValues> modelAnswers(const Model& model,
                                        const std::vector<std::vector<Feature>>& features);

}  // namespace place_recognition
