#include "features/feature_extractor.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "features/feature_images.h"
#include "features/small_network.h"

namespace place_recognition {
namespace {

std::vector<FeatureOptions> allKinds() {
  return {CrfhOptions(), LocalFeatureOptions(), LbpOptions(),
          Mr8Options(),  HogOptions(),          SmallNetwork::options()};
}

TEST(FeatureExtractor, OfEachKindLeavesTheCallersImagesAsTheyAre) {
  ASSERT_EQ(allKinds().size(), std::variant_size_v<FeatureOptions>);
  const cv::Mat colour = noise(100, 80, CV_8UC3);
  const cv::Mat grey = noise(100, 80, CV_8UC1);
  for (const FeatureOptions& options : allKinds()) {
    const cv::Mat colour_before = colour.clone();
    const cv::Mat grey_before = grey.clone();
    const auto extractor = makeFeatureExtractor(options);
    Feature feature;
    for (const cv::Mat& image : {colour, grey, colour, grey}) extractor->extract(image, feature);
    EXPECT_EQ(cv::norm(grey, grey_before, cv::NORM_INF), 0) << "kind " << options.index();
    EXPECT_EQ(cv::norm(colour, colour_before, cv::NORM_INF), 0) << "kind " << options.index();
    grey_before.copyTo(grey);
  }
}

}  // namespace
}  // namespace place_recognition
