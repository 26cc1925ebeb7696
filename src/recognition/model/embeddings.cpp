#include "recognition/model/embeddings.h"

#include <map>

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

void shareNetworks(TrainingOptions& options) {
  const std::vector<EmbeddingOptions*> embeddings = embeddingsOf(options);
  for (EmbeddingOptions* embedding : embeddings) {
    for (const EmbeddingOptions* earlier : embeddings) {
      if (earlier == embedding) break;
      if (earlier->loaded->onnx == embedding->loaded->onnx) embedding->loaded = earlier->loaded;
    }
  }
}

std::vector<std::vector<std::size_t>> cuesByNetwork(const TrainingOptions& options) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<const Network*, std::size_t> group_of;
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    const auto* embedding = std::get_if<EmbeddingOptions>(&options.cues[c].feature);
    const bool is_first =
        !embedding || group_of.emplace(embedding->loaded.get(), groups.size()).second;
    if (is_first) groups.emplace_back();
    groups[is_first ? groups.size() - 1 : group_of[embedding->loaded.get()]].push_back(c);
  }
  return groups;
}

TrainingOptions withNetworks(TrainingOptions options) {
  for (EmbeddingOptions* embedding : embeddingsOf(options)) {
    if (!embedding->loaded) loadNetwork(*embedding);
  }
  shareNetworks(options);
  return options;
}

}  // namespace place_recognition
