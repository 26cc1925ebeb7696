#pragma once

#include "place_recognition/model.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// What a model remembers of the recordings that it learned: its support vectors as samples of run
/// 0, in the order in which they were recorded. Each vector is a sample of its own, of which only
/// the cue is there that it belongs to.
Samples rememberedSamples(const Model& model);

/// The samples of `remembered` and, behind them, those of `fresh`, whose runs are counted on.
Samples joinSamples(Samples remembered, Samples fresh);

}  // namespace place_recognition
