#pragma once

#include <memory>
#include <vector>

#include "features/feature_extractor.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

class NetworkPass;

/// Extractors of cues, of which those with the same network and the same input share its run.
class SharedNetworks {
 public:
  /// `cues`: all for which extractor() will be called; they contain their networks.
  explicit SharedNetworks(const std::vector<CueOptions>& cues);

  /// Like makeFeatureExtractor(cue.feature).
  std::unique_ptr<FeatureExtractor> extractor(const CueOptions& cue);

  /// To be called before each new image.
  void forget();

 private:
  struct Shared {
    CueOptions first;  ///< of those that share the run
    std::vector<EmbeddingOptions> embeddings;
    std::shared_ptr<NetworkPass> pass;
  };

  /// Null if there is none.
  Shared* find(const CueOptions& cue);

  std::vector<Shared> shared_;
};

}  // namespace place_recognition
