#include "features/feature_extractor.h"

#include "features/crfh.h"
#include "features/embedding.h"
#include "features/hog.h"
#include "features/lbp.h"
#include "features/local_features.h"
#include "features/mr8.h"

namespace place_recognition {
namespace {

std::unique_ptr<FeatureExtractor> make(const CrfhOptions& options) {
  return std::make_unique<CrfhExtractor>(options);
}

std::unique_ptr<FeatureExtractor> make(const LocalFeatureOptions& options) {
  return std::make_unique<LocalFeatureExtractor>(options);
}

std::unique_ptr<FeatureExtractor> make(const LbpOptions& options) {
  return std::make_unique<LbpExtractor>(options);
}

std::unique_ptr<FeatureExtractor> make(const Mr8Options& options) {
  return std::make_unique<Mr8Extractor>(options);
}

std::unique_ptr<FeatureExtractor> make(const HogOptions& options) {
  return std::make_unique<HogExtractor>(options);
}

std::unique_ptr<FeatureExtractor> make(const EmbeddingOptions& options) {
  return std::make_unique<EmbeddingExtractor>(options);
}

}  // namespace

std::unique_ptr<FeatureExtractor> makeFeatureExtractor(const FeatureOptions& options) {
  return std::visit([](const auto& alternative) { return make(alternative); }, options);
}

}  // namespace place_recognition
