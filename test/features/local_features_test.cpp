#include "features/local_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "features/local_images.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

cv::Mat image() { return cv::Mat1b(texture(320, 240, 1)); }

Feature extract(const cv::Mat& image, const LocalFeatureOptions& options = {}) {
  Feature feature;
  makeFeatureExtractor(options)->extract(image, feature);
  return feature;
}

std::vector<std::uint8_t> descriptors(const Feature& feature) {
  return std::get<DescriptorSet>(feature).descriptors;
}

TEST(LocalFeatures, AreTheSameEveryTime) {
  LocalFeatureExtractor extractor{LocalFeatureOptions()};
  Feature first, second;
  extractor.extract(image(), first);
  EXPECT_GT(std::get<DescriptorSet>(first).size(), 100u);
  extractor.extract(cv::Mat1b(texture(99, 111, 2)), second);
  extractor.extract(image(), second);
  EXPECT_EQ(descriptors(first), descriptors(second));
  EXPECT_EQ(descriptors(first), descriptors(extract(image())));
}

TEST(LocalFeatures, OfGreyImagesInColourAreTheSame) {
  cv::Mat colour;
  cv::cvtColor(image(), colour, cv::COLOR_GRAY2BGR);
  EXPECT_EQ(descriptors(extract(image())), descriptors(extract(colour)));
}

TEST(LocalFeatures, AreTheStrongestUpToTheCap) {
  LocalFeatureOptions options;
  options.max_points = 20000;
  const std::vector<std::uint8_t> all = descriptors(extract(image(), options));
  for (const int cap : {5, 17, 100}) {
    options.max_points = cap;
    const std::vector<std::uint8_t> some = descriptors(extract(image(), options));
    ASSERT_EQ(some.size(), cap * DescriptorSet::kDimension);
    EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin()));
  }
}

TEST(LocalFeatures, AreMissingBelowTheMinimum) {
  cv::Mat1b corner(60, 60, std::uint8_t{50});
  corner(cv::Rect(20, 20, 40, 40)) = 180;
  LocalFeatureOptions options;
  options.min_points = 1;
  const std::size_t count = std::get<DescriptorSet>(extract(corner, options)).size();
  options.min_points = static_cast<int>(count);
  EXPECT_FALSE(isMissing(extract(corner, options)));

  options.min_points = static_cast<int>(count) + 1;
  LocalFeatureExtractor extractor(options);
  Feature feature = DescriptorSet();
  extractor.extract(corner, feature);
  EXPECT_TRUE(isMissing(feature));
  EXPECT_EQ(extractor.missingReason(), "only " + std::to_string(count) + " interest points, " +
                                           std::to_string(count + 1) + " needed");

  EXPECT_TRUE(isMissing(extract(cv::Mat1b(1, 1, std::uint8_t{3}))));
  EXPECT_TRUE(isMissing(extract(cv::Mat1b(480, 640, std::uint8_t{90}))));
}

TEST(LocalFeatures, UprightGiveOneDescriptorPerPoint) {
  LocalFeatureOptions options;
  options.max_points = 20000;
  const std::size_t turned = std::get<DescriptorSet>(extract(image(), options)).size();
  options.upright = true;
  const std::size_t upright = std::get<DescriptorSet>(extract(image(), options)).size();
  EXPECT_LT(upright, turned);
  HarrisLaplace detector({options.sigma, options.steps, options.octaves, options.alpha,
                          options.cornerness_threshold, options.laplacian_threshold});
  EXPECT_EQ(upright, detector.detect(cv::Mat1f(image()), 20000).size());
}

TEST(LocalFeatureOptions, RefuseWhatIsOutOfRange) {
  const auto refused = [](auto change) {
    LocalFeatureOptions options;
    change(options);
    EXPECT_THROW(makeFeatureExtractor(options), Error);
  };
  EXPECT_NO_THROW(LocalFeatureOptions().check());
  refused([](auto& o) { o.sigma = 0.9; });
  refused([](auto& o) { o.sigma = std::nan(""); });
  refused([](auto& o) { o.steps = 3; });
  refused([](auto& o) { o.octaves = 0; });
  refused([](auto& o) { o.alpha = -0.1; });
  refused([](auto& o) { o.cornerness_threshold = 0; });
  refused([](auto& o) { o.laplacian_threshold = -1; });
  refused([](auto& o) { o.max_points = 0; });
  refused([](auto& o) { o.min_points = 0; });
  refused([](auto& o) { o.min_points = o.max_points + 1; });
}

}  // namespace
}  // namespace place_recognition
