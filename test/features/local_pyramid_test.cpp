#include <gtest/gtest.h>

#include <cmath>

#include "features/gaussian_pyramid.h"
#include "features/local_images.h"

namespace place_recognition {
namespace {

TEST(GaussianPyramid, NumbersScalesThroughTheOctaves) {
  GaussianPyramid pyramid(1.2, 4, 2, 3);
  pyramid.build(texture(100, 90, 1));
  EXPECT_EQ(pyramid.octaves(), 3);
  EXPECT_EQ(pyramid.scales(), 3 * 4 + 2);
  EXPECT_DOUBLE_EQ(pyramid.sigma(0), 1.2);
  EXPECT_DOUBLE_EQ(pyramid.sigma(4), 2.4);
  EXPECT_DOUBLE_EQ(pyramid.sigma(6), 2.4 * std::sqrt(2.0));
  for (int n = 0; n < pyramid.scales(); ++n) {
    EXPECT_EQ(pyramid.nearestScale(pyramid.sigma(n) * 1.08), n);
    EXPECT_EQ(pyramid.octaveOf(n), n < 6 ? 0 : n < 10 ? 1 : 2);
  }
  EXPECT_EQ(pyramid.nearestScale(0.1), 0);
  EXPECT_EQ(pyramid.nearestScale(1000), pyramid.scales() - 1);
}

class DotTest : public testing::TestWithParam<int> {};

TEST_P(DotTest, IsAGaussian) {
  // The pyramid assumes that the camera has blurred the dot, which it has not: so each level has
  // the variance sigma^2 less that of the blur. A wide pyramid leaves nothing at the edges.
  constexpr int kMiddle = 128;
  cv::Mat1f dot(GetParam(), GetParam(), 0.0f);
  dot(kMiddle, kMiddle) = 10000;
  GaussianPyramid pyramid(1.2, 4, 2, 3);
  pyramid.build(dot);
  for (int n = 0; n < pyramid.scales(); ++n) {
    const int octave = pyramid.octaveOf(n);
    const cv::Mat1f& level = pyramid.level(octave, n);
    const double variance = pyramid.sigma(n) * pyramid.sigma(n) - 0.25;
    const double peak = 10000 / (2 * CV_PI * variance);
    double worst = 0;
    for (int y = 0; y < level.rows; ++y) {
      for (int x = 0; x < level.cols; ++x) {
        const cv::Point2d d =
            pyramid.toImage(octave, cv::Point2d(x, y)) - cv::Point2d(kMiddle, kMiddle);
        const double expected = peak * std::exp(-d.dot(d) / (2 * variance));
        worst = std::max(worst, std::abs(level(y, x) - expected));
      }
    }
    EXPECT_LT(worst, 0.01 * peak) << "scale " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(OddAndEvenSides, DotTest, testing::Values(257, 256, 250));

TEST(GaussianPyramid, LiesSymmetricallyInTheImage) {
  for (const cv::Size size : {cv::Size(640, 480), cv::Size(101, 230), cv::Size(97, 99)}) {
    const cv::Point2d last(size.width - 1, size.height - 1);
    const cv::Mat1f image = texture(size.width, size.height, 3);
    cv::Mat1f flipped_image, flipped;
    cv::flip(image, flipped_image, -1);
    GaussianPyramid pyramid(1.2, 4, 2, 4), other(1.2, 4, 2, 4);
    pyramid.build(image);
    other.build(flipped_image);
    for (int n = 0; n < pyramid.scales(); ++n) {
      const int octave = pyramid.octaveOf(n);
      const cv::Mat1f& level = pyramid.level(octave, n);
      cv::flip(other.level(octave, n), flipped, -1);
      EXPECT_EQ(cv::norm(level, flipped, cv::NORM_INF), 0) << size << " scale " << n;
      const cv::Point2d corner = pyramid.toImage(octave, {0, 0});
      const cv::Point2d opposite = pyramid.toImage(octave, {level.cols - 1.0, level.rows - 1.0});
      EXPECT_EQ(corner + opposite, last);
      EXPECT_EQ(pyramid.toOctave(octave, opposite), cv::Point2d(level.cols - 1, level.rows - 1));
    }
  }
}

TEST(GaussianPyramid, KeepsConstantsAndStopsAtSmallSides) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(2, 7), cv::Size(23, 50), cv::Size(24, 24)}) {
    GaussianPyramid pyramid(1.2, 4, 2, 5);
    pyramid.build(cv::Mat1f(size, 77.0f));
    EXPECT_EQ(pyramid.octaves(), size == cv::Size(24, 24) ? 2 : 1) << size;
    EXPECT_LT(cv::norm(pyramid.level(0, 5) - 77.0f, cv::NORM_INF), 1e-3) << size;
  }
}

}  // namespace
}  // namespace place_recognition
