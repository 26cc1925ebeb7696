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

/// The cues in groups: those that share a network, in which one alone takes as long as all, and
/// each other cue by itself.
std::vector<std::vector<std::size_t>> cuesByNetwork(const TrainingOptions& options);

/// `options` with all networks loaded that they name. Throws Error like loadNetwork().
TrainingOptions withNetworks(TrainingOptions options);

}  // namespace place_recognition
