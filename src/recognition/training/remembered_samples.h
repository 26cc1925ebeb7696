#pragma once

#include "place_recognition/model.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// The support vectors of a model as samples of recording 0, in the order in which they were
/// recorded. Each vector is a separate sample that has only its own cue.
Samples rememberedSamples(const Model& model);

/// Appends `others` (new samples, or those that another model remembers) to `remembered`, which
/// consists of remembered samples only; the recordings of `others` are renumbered.
Samples joinSamples(Samples remembered, Samples others);

/// Throws Error, a sentence that names both, if `other` cannot join `model` because `model` would
/// have extracted different features from the same images.
void requireJoinable(const Model& model, const Model& other);

}  // namespace place_recognition
