#include "recognition/frames/shared_networks.h"

#include <algorithm>
#include <cassert>

#include "features/embedding.h"
#include "features/network_pass.h"
#include "recognition/model/embeddings.h"

namespace place_recognition {

SharedNetworks::SharedNetworks(const std::vector<CueOptions>& cues) {
  for (const CueOptions& cue : cues) {
    const auto* const embedding = std::get_if<EmbeddingOptions>(&cue.feature);
    if (!embedding) continue;
    Shared* shared = find(cue);
    if (!shared) shared = &shared_.emplace_back(Shared{cue, {}, nullptr});
    shared->embeddings.push_back(*embedding);
  }
  for (Shared& shared : shared_) shared.pass = std::make_shared<NetworkPass>(shared.embeddings);
}

SharedNetworks::Shared* SharedNetworks::find(const CueOptions& cue) {
  const auto found = std::find_if(shared_.begin(), shared_.end(), [&](const Shared& shared) {
    return shareNetworkRun(shared.first, cue);
  });
  return found == shared_.end() ? nullptr : &*found;
}

std::unique_ptr<FeatureExtractor> SharedNetworks::extractor(const CueOptions& cue) {
  const auto* const embedding = std::get_if<EmbeddingOptions>(&cue.feature);
  if (!embedding) return makeFeatureExtractor(cue.feature);
  Shared* const shared = find(cue);
  assert(shared);
  return std::make_unique<EmbeddingExtractor>(*embedding, shared->pass);
}

void SharedNetworks::forget() {
  for (const Shared& shared : shared_) shared.pass->forget();
}

}  // namespace place_recognition
