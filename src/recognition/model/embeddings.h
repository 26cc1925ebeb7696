#pragma once

#include <vector>

#include "place_recognition/training_options.h"

namespace place_recognition {

/// The features of type `embedding` among the cues, in order.
std::vector<EmbeddingOptions*> embeddingsOf(TrainingOptions& options);
std::vector<const EmbeddingOptions*> embeddingsOf(const TrainingOptions& options);

/// `options` with all networks loaded that they name. Throws Error like loadNetwork().
TrainingOptions withNetworks(TrainingOptions options);

}  // namespace place_recognition
