#include "place_recognition/feature_extractor.h"

#include "features/crfh.h"

namespace place_recognition {
namespace {

std::unique_ptr<FeatureExtractor> make(const CrfhOptions& options) {
  return std::make_unique<CrfhExtractor>(options);
}

}  // namespace

std::unique_ptr<FeatureExtractor> makeFeatureExtractor(const FeatureOptions& options) {
  return std::visit([](const auto& alternative) { return make(alternative); }, options);
}

}  // namespace place_recognition
