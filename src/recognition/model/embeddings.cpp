#include "recognition/model/embeddings.h"

#include <algorithm>

#include "base/options.h"
#include "place_recognition/network.h"

namespace place_recognition {
namespace {

/// All options but those that concern the output alone.
std::string inputOf(EmbeddingOptions embedding) {
  const EmbeddingOptions defaults;
  embedding.stride = defaults.stride;
  embedding.columns = defaults.columns;
  embedding.power = defaults.power;
  return writeOptions(embedding);
}

}  // namespace

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

bool shareNetworkRun(const CueOptions& a, const CueOptions& b) {
  const auto* first = std::get_if<EmbeddingOptions>(&a.feature);
  const auto* second = std::get_if<EmbeddingOptions>(&b.feature);
  return first && second && first->loaded == second->loaded && a.normalize == b.normalize &&
         inputOf(*first) == inputOf(*second);
}

std::vector<std::vector<std::size_t>> cuesByNetworkRun(const TrainingOptions& options) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& cues) {
      return shareNetworkRun(options.cues[cues.front()], options.cues[c]);
    });
    if (group == groups.end()) {
      groups.push_back({c});
    } else {
      group->push_back(c);
    }
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
