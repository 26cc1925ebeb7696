#include "recognition/model/embeddings.h"

#include "place_recognition/network.h"

namespace place_recognition {

std::vector<EmbeddingOptions*> embeddingsOf(TrainingOptions& options) {
  std::vector<EmbeddingOptions*> embeddings;
  for (CueOptions& cue : options.cues) {
    if (auto* embedding = std::get_if<EmbeddingOptions>(&cue.feature)) {
      embeddings.push_back(embedding);
    }
  }
  return embeddings;
}

std::vector<const EmbeddingOptions*> embeddingsOf(const TrainingOptions& options) {
  std::vector<const EmbeddingOptions*> embeddings;
  for (const CueOptions& cue : options.cues) {
    if (const auto* embedding = std::get_if<EmbeddingOptions>(&cue.feature)) {
      embeddings.push_back(embedding);
    }
  }
  return embeddings;
}

TrainingOptions withNetworks(TrainingOptions options) {
  for (EmbeddingOptions* embedding : embeddingsOf(options)) {
    if (!embedding->loaded) embedding->loaded = loadNetwork(*embedding);
  }
  return options;
}

}  // namespace place_recognition
