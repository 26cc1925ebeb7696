#include "features/hog.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "features/feature_images.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Returns an image whose grey levels rise by these slopes per pixel.
cv::Mat1b ramp(int width, int height, int slope_x, int slope_y) {
  cv::Mat1b image(height, width);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image(y, x) = static_cast<std::uint8_t>(100 + slope_x * x + slope_y * y);
    }
  }
  return image;
}

HogOptions grid(int rows, int columns, int orientations = 9) {
  HogOptions options;
  options.rows = rows;
  options.columns = columns;
  options.orientations = orientations;
  return options;
}

std::string whyMissing(const cv::Mat& image, const HogOptions& options = {}) {
  Feature feature = DenseVector{{1}};
  const auto extractor = makeFeatureExtractor(options);
  extractor->extract(image, feature);
  return isMissing(feature) ? extractor->missingReason() : "";
}

void expectNear(const std::vector<float>& values, const std::vector<float>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-6) << i;
}

/// The definition, pixel by pixel, in double precision.
std::vector<float> reference(const cv::Mat1b& image, const HogOptions& options) {
  const int n = options.orientations;
  std::vector<double> sums(static_cast<std::size_t>(options.rows * options.columns * n));
  for (int y = 1; y + 1 < image.rows; ++y) {
    for (int x = 1; x + 1 < image.cols; ++x) {
      const int row = (y - 1) * options.rows / (image.rows - 2);
      const int column = (x - 1) * options.columns / (image.cols - 2);
      const double dx = image(y, x + 1) - image(y, x - 1);
      const double dy = image(y + 1, x) - image(y - 1, x);
      const double angle = std::fmod(std::atan2(dy, dx) + CV_PI, CV_PI);
      for (int k = 0; k < n; ++k) {
        double distance = std::abs(angle / CV_PI * n - (k + 0.5));
        distance = std::min(distance, n - distance);
        const double share = std::max(0.0, 1 - distance);
        sums[static_cast<std::size_t>((row * options.columns + column) * n + k)] +=
            share * std::hypot(dx, dy);
      }
    }
  }
  const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
  std::vector<float> values;
  for (const double sum : sums) values.push_back(static_cast<float>(sum / total));
  return values;
}

TEST(Hog, IsThatOfTheDefinition) {
  const cv::Mat1b image = noise(67, 41, CV_8UC1);
  for (const HogOptions& options : {HogOptions(), grid(3, 5, 7), grid(1, 1, 2), grid(16, 16, 36)}) {
    expectNear(extractDense(image, options), reference(image, options));
  }
}

TEST(Hog, OfRampsIsTheirDirection) {
  // With two orientations, the bins' centres are 45 and 135 degrees.
  expectNear(extractDense(ramp(20, 20, 3, 3), grid(1, 1, 2)), {1, 0});
  expectNear(extractDense(ramp(20, 20, -3, 3), grid(1, 1, 2)), {0, 1});
  expectNear(extractDense(ramp(20, 20, -3, -3), grid(1, 1, 2)), {1, 0});
  // 0 and 180 degrees are the same direction, between the last bin and the first.
  for (const int slope : {4, -4}) {
    expectNear(extractDense(ramp(20, 20, slope, 0), grid(1, 1, 4)), {0.5, 0, 0, 0.5});
    expectNear(extractDense(ramp(20, 20, 0, slope), grid(1, 1, 4)), {0, 0.5, 0.5, 0});
  }
}

TEST(Hog, HasOneHistogramPerCellRowByRow) {
  cv::Mat1b image(42, 62, static_cast<std::uint8_t>(100));
  ramp(20, 20, 5, 5).copyTo(image(cv::Rect(41, 1, 20, 20)));  // its edges are within its cell
  image.row(20) = 100;
  image.col(41) = 100;
  const std::vector<float> values = extractDense(image, grid(2, 3));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i / 9 == 2) continue;
    EXPECT_EQ(values[i], 0) << i;
  }
  EXPECT_NEAR(std::accumulate(values.begin() + 18, values.begin() + 27, 0.0), 1, 1e-6);
}

TEST(Hog, DoesNotDependOnContrastSignAndColour) {
  const cv::Mat1b image = noise(50, 40, CV_8UC1, 100);
  const std::vector<float> values = extractDense(image, HogOptions());
  expectNear(extractDense(image * 2, HogOptions()), values);
  expectNear(extractDense(255 - image, HogOptions()), values);
  cv::Mat three;
  cv::merge(std::vector<cv::Mat>(3, image), three);
  EXPECT_EQ(extractDense(three, HogOptions()), values);
}

TEST(Hog, OfAnImageUpsideDownHasItsRowsUpsideDown) {
  const cv::Mat1b image = noise(50, 42, CV_8UC1);
  cv::Mat turned;
  cv::rotate(image, turned, cv::ROTATE_180);
  const std::vector<float> values = extractDense(image, HogOptions()),
                           of_turned = extractDense(turned, HogOptions());
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_NEAR(of_turned[9 * row + k], values[9 * (3 - row) + k], 1e-6);
    }
  }
}

TEST(Hog, OfAWideImageIsThatOfTheScaledOne) {
  HogOptions options;
  options.width = 64;
  const cv::Mat1b image = noise(160, 90, CV_8UC1);
  cv::Mat scaled;
  cv::resize(image, scaled, cv::Size(64, 36), 0, 0, cv::INTER_AREA);
  EXPECT_EQ(extractDense(image, options), extractDense(scaled, options));
  options.width = 160;
  EXPECT_NE(extractDense(image, options), extractDense(scaled, options));
}

TEST(Hog, IsMissingWithoutGradientsOrPixels) {
  EXPECT_EQ(whyMissing(cv::Mat1b(40, 40, static_cast<std::uint8_t>(3))),
            "the image has no gradient");
  EXPECT_EQ(whyMissing(noise(40, 5, CV_8UC1)),
            "the image of 40 x 5 pixels is too small for its cells");
  EXPECT_EQ(whyMissing(noise(3, 6, CV_8UC1)), "");
  EXPECT_EQ(whyMissing(noise(3, 6, CV_8UC1), grid(1, 2)),
            "the image of 3 x 6 pixels is too small for its cells");
  EXPECT_EQ(whyMissing(noise(1, 1, CV_8UC1)),
            "the image of 1 x 1 pixels is too small for its cells");
  EXPECT_EQ(whyMissing(noise(1000, 1, CV_8UC1)),
            "the image of 1000 x 1 pixels is too small for its cells");
}

TEST(Hog, OptionsAreChecked) {
  HogOptions options;
  options.rows = 17;
  EXPECT_THROW(HogExtractor{options}, Error);
  options = {};
  options.columns = 0;
  EXPECT_THROW(HogExtractor{options}, Error);
  options = {};
  options.orientations = 1;
  EXPECT_THROW(HogExtractor{options}, Error);
  options = {};
  options.width = 31;
  EXPECT_THROW(HogExtractor{options}, Error);
}

}  // namespace
}  // namespace place_recognition
