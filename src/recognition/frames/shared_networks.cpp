#include "recognition/frames/shared_networks.h"

#include <algorithm>
#include <cassert>

#include "base/options.h"
#include "features/embedding.h"
#include "features/network_pass.h"

namespace place_recognition {
namespace {

/// All options but those that concern the output alone.
std::string inputOf(const CueOptions& cue, EmbeddingOptions embedding) {
  const EmbeddingOptions defaults;
  embedding.stride = defaults.stride;
  embedding.columns = defaults.columns;
  embedding.power = defaults.power;
  return cue.normalize + "\n" + writeOptions(embedding);
}

}  // namespace

SharedNetworks::SharedNetworks(const std::vector<CueOptions>& cues) {
  for (const CueOptions& cue : cues) {
    const auto* const embedding = std::get_if<EmbeddingOptions>(&cue.feature);
    if (!embedding) continue;
    Shared* shared = find(cue, *embedding);
    if (!shared) shared = &shared_.emplace_back(Shared{inputOf(cue, *embedding), {}, nullptr});
    shared->embeddings.push_back(*embedding);
  }
  for (Shared& shared : shared_) shared.pass = std::make_shared<NetworkPass>(shared.embeddings);
}

SharedNetworks::Shared* SharedNetworks::find(const CueOptions& cue,
                                             const EmbeddingOptions& embedding) {
  const std::string input = inputOf(cue, embedding);
  const auto found = std::find_if(shared_.begin(), shared_.end(), [&](const Shared& shared) {
    return shared.input == input && shared.embeddings[0].loaded == embedding.loaded;
  });
  return found == shared_.end() ? nullptr : &*found;
}

std::unique_ptr<FeatureExtractor> SharedNetworks::extractor(const CueOptions& cue) {
  const auto* const embedding = std::get_if<EmbeddingOptions>(&cue.feature);
  if (!embedding) return makeFeatureExtractor(cue.feature);
  Shared* const shared = find(cue, *embedding);
  assert(shared);
  return std::make_unique<EmbeddingExtractor>(*embedding, shared->pass);
}

void SharedNetworks::forget() {
  for (const Shared& shared : shared_) shared.pass->forget();
}

}  // namespace place_recognition
