#pragma once

#include <cstddef>
#include <vector>

#include "place_recognition/training_options.h"

namespace place_recognition {

/// The features of type `embedding` among the cues, in order.
std::vector<EmbeddingOptions*> embeddingsOf(TrainingOptions& options);
std::vector<const EmbeddingOptions*> embeddingsOf(const TrainingOptions& options);

/// Lets equal networks, which must be loaded, be one in memory.
void shareNetworks(TrainingOptions& options);

/// Whether one run of a network, which must be loaded, computes both cues: they have all options in
/// common but those that concern its output alone.
bool shareNetworkRun(const CueOptions& a, const CueOptions& b);

/// The cues in groups: those that share the run of a network, in which one alone takes as long as
/// all, and each other cue by itself.
std::vector<std::vector<std::size_t>> cuesByNetworkRun(const TrainingOptions& options);

/// `options` with all networks loaded that they name. Throws Error like loadNetwork().
TrainingOptions withNetworks(TrainingOptions options);

}  // namespace place_recognition
