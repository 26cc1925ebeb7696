#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "place_recognition/model.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// What a model remembers of the recordings that it learned: its support vectors as samples of run
/// 0, in the order in which they were recorded. Each vector is a sample of its own, of which only
/// the cue is there that it belongs to.
Samples rememberedSamples(const Model& model);

/// The samples of `remembered`, all of which are, and behind them those of `others`, whose runs are
/// counted on: fresh ones, or those that another model remembers.
Samples joinSamples(Samples remembered, Samples others);

/// Throws Error, a sentence that names both, if `other` cannot join `model`: if its features are
/// not those that `model` would have extracted from the same images.
void requireJoinable(const Model& model, const Model& other);

/// The machines of each cue of `model`, over its remembered samples, for more places: those of the
/// model are `place_before` among `places`, and no sample is known of the others. Empty if they are
/// one-against-one.
std::vector<BinarySvms> learnedMachines(const Model& model, const std::vector<int>& place_before,
                                        std::size_t places);

}  // namespace place_recognition
