#include "recognition/frames/shared_networks.h"

#include <algorithm>

#include "base/options.h"
#include "features/embedding.h"
#include "features/network_pass.h"

namespace place_recognition {
namespace {

std::string inputOf(const CueOptions& cue, EmbeddingOptions embedding) {
  embedding.columns = 1;
  return cue.normalize + "\n" + writeOptions(embedding);
}

}  // namespace

std::unique_ptr<FeatureExtractor> SharedNetworks::extractor(const CueOptions& cue) {
  const auto* const embedding = std::get_if<EmbeddingOptions>(&cue.feature);
  if (!embedding) return makeFeatureExtractor(cue.feature);
  const std::string input = inputOf(cue, *embedding);
  auto shared = std::find_if(shared_.begin(), shared_.end(), [&](const Shared& other) {
    return other.input == input && other.network == embedding->loaded;
  });
  if (shared == shared_.end()) {
    shared_.push_back({input, embedding->loaded, std::make_shared<NetworkPass>(*embedding)});
    shared = shared_.end() - 1;
  }
  return std::make_unique<EmbeddingExtractor>(*embedding, shared->pass);
}

void SharedNetworks::forget() {
  for (const Shared& shared : shared_) shared.pass->forget();
}

}  // namespace place_recognition
