#include "features/sift_descriptor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "features/harris_laplace.h"
#include "features/local_images.h"

namespace place_recognition {
namespace {

using Descriptor = std::array<std::uint8_t, SiftDescriptor::kDimension>;

Descriptor describe(const cv::Mat1f& level, float x, float y, float sigma, float angle) {
  Descriptor descriptor;
  SiftDescriptor().describe(level, x, y, sigma, angle, descriptor.data());
  return descriptor;
}

int largestDifference(const Descriptor& a, const Descriptor& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// The definition (Lowe 2004, section 6), sample by sample in double precision.
Descriptor reference(const cv::Mat1f& level, double x, double y, double sigma, double angle) {
  std::array<double, SiftDescriptor::kDimension> bins{};
  const double cell = 3 * sigma;
  for (int row = 1; row < level.rows - 1; ++row) {
    for (int column = 1; column < level.cols - 1; ++column) {
      const double dx = column - x, dy = row - y;
      const double u = (std::cos(angle) * dx + std::sin(angle) * dy) / cell;
      const double v = (-std::sin(angle) * dx + std::cos(angle) * dy) / cell;
      if (std::max(std::abs(u), std::abs(v)) > 2.5) continue;  // outside every histogram
      const double gx = level(row, column + 1) - level(row, column - 1);
      const double gy = level(row + 1, column) - level(row - 1, column);
      const double weight = std::hypot(gx, gy) * std::exp(-(u * u + v * v) / 8);
      const double direction = (angle - std::atan2(gy, gx)) * 8 / (2 * CV_PI);
      for (int i = 0; i < SiftDescriptor::kDimension; ++i) {
        const double row_distance = std::abs(v + 1.5 - i / 32);
        const double column_distance = std::abs(u + 1.5 - i / 8 % 4);
        const double turn = std::abs(std::remainder(direction - i % 8, 8));
        bins[i] += weight * std::max(0.0, 1 - row_distance) * std::max(0.0, 1 - column_distance) *
                   std::max(0.0, 1 - turn);
      }
    }
  }
  const auto norm = [&bins] {
    return std::sqrt(std::inner_product(bins.begin(), bins.end(), bins.begin(), 0.0));
  };
  const double limit = 0.2 * norm();
  for (double& bin : bins) bin = std::min(bin, limit);
  const double unit = 512 / norm();
  Descriptor descriptor;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    descriptor[i] = static_cast<std::uint8_t>(std::min(std::round(bins[i] * unit), 255.0));
  }
  return descriptor;
}

TEST(SiftDescriptor, AgreesWithTheDefinition) {
  const cv::Mat1f level = texture(120, 100, 1);
  cv::RNG random(1);
  for (int i = 0; i < 30; ++i) {
    // Including points near the edge, whose patch is cut.
    const double x = random.uniform(0.0, 119.0), y = random.uniform(0.0, 99.0);
    const double sigma = random.uniform(1.6, 3.2), angle = random.uniform(-CV_PI, CV_PI);
    EXPECT_LE(largestDifference(describe(level, x, y, sigma, angle),
                                reference(level, x, y, sigma, angle)),
              1)
        << x << ", " << y << " sigma " << sigma << " angle " << angle;
  }
}

TEST(SiftDescriptor, OfARampHasItsDirectionOnly) {
  for (const double angle : {-3.0, -1.2, 0.0, 0.5, 2.9}) {
    cv::Mat1f ramp(80, 80);
    for (int y = 0; y < ramp.rows; ++y) {
      for (int x = 0; x < ramp.cols; ++x) {
        ramp(y, x) = static_cast<float>(128 + 1.5 * (std::cos(angle) * x + std::sin(angle) * y));
      }
    }
    SiftDescriptor sift;
    const std::vector<float> orientations = sift.orientations(ramp, 40, 40, 2);
    ASSERT_EQ(orientations.size(), 1u);
    EXPECT_NEAR(std::remainder(orientations[0] - angle, 2 * CV_PI), 0, CV_PI / 36) << angle;
    const Descriptor descriptor = describe(ramp, 40, 40, 2, static_cast<float>(angle));
    for (int i = 0; i < SiftDescriptor::kDimension; ++i) {
      EXPECT_EQ(descriptor[i] > 1, i % 8 == 0) << i;
    }
  }
}

/// A ridge across x: slope 1 at the left, -`right` at the right.
cv::Mat1f ridge(float right) {
  cv::Mat1f image(81, 81);
  for (int y = 0; y < 81; ++y) {
    for (int x = 0; x < 81; ++x) image(y, x) = x < 40 ? x : 40 - right * (x - 40);
  }
  return image;
}

TEST(SiftDescriptor, PeaksOfEightyPercentGiveAnOrientationEach) {
  SiftDescriptor sift;
  const std::vector<float> both = sift.orientations(ridge(0.9f), 40, 40, 2);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0], 0, 1e-3);
  EXPECT_NEAR(std::abs(both[1]), CV_PI, 1e-3);
  EXPECT_EQ(sift.orientations(ridge(0.7f), 40, 40, 2).size(), 1u);
  EXPECT_TRUE(sift.orientations(cv::Mat1f(50, 50, 9.0f), 25, 25, 2).empty());
}

TEST(SiftDescriptor, IgnoresBrightnessContrastAndQuarterTurns) {
  const cv::Mat1f level = texture(101, 101, 3);
  cv::Mat1f turned;
  cv::rotate(level, turned, cv::ROTATE_90_CLOCKWISE);
  const Descriptor descriptor = describe(level, 45.3f, 60.8f, 2, 0.4f);
  EXPECT_LE(largestDifference(descriptor, describe(level * 0.5 + 60, 45.3f, 60.8f, 2, 0.4f)), 1);
  const float angle = static_cast<float>(0.4 + CV_PI / 2);
  EXPECT_LE(largestDifference(descriptor, describe(turned, 100 - 60.8f, 45.3f, 2, angle)), 1);
}

TEST(SiftDescriptor, HasTheLengthOf512) {
  const Descriptor d = describe(texture(101, 101, 9), 50, 50, 2, 0);
  EXPECT_NEAR(std::sqrt(std::inner_product(d.begin(), d.end(), d.begin(), 0.0)), 512, 6);
  for (const int value : describe(cv::Mat1f(50, 50, 9.0f), 25, 25, 2, 0)) EXPECT_EQ(value, 0);
}

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 4)

/// OpenCV's octaves keep the first of every two pixels, ours are symmetric. The two agree if each
/// octave has an odd number of pixels, except for the last pixel, which OpenCV lacks.
cv::Mat1b cutToOddOctaves(const cv::Mat1b& image) {
  constexpr int kCoarsestPixel = 16;
  const auto cut = [](int side) { return (side - 1) / kCoarsestPixel * kCoarsestPixel + 1; };
  return image(cv::Rect(0, 0, cut(image.cols), cut(image.rows))).clone();
}

/// Descriptors of one image's Harris-Laplace points, ours and OpenCV's.
struct Described {
  std::vector<Descriptor> ours, theirs;
  std::vector<bool> whole;  ///< whether the patch ends before the last pixels
};

Described describeBoth(const cv::Mat1b& image) {
  constexpr double kSigma = 2;
  constexpr int kSteps = 4, kLimit = 300;
  HarrisLaplace detector({kSigma, kSteps, 5, 0.05, 100, 5});
  SiftDescriptor sift;
  const std::vector<InterestPoint>& points = detector.detect(cv::Mat1f(image), kLimit);
  const GaussianPyramid& pyramid = detector.pyramid();
  Described result;
  std::vector<cv::KeyPoint> keypoints;
  for (const InterestPoint& point : points) {
    const int scale = pyramid.nearestScale(point.sigma);
    const int octave = pyramid.octaveOf(scale);
    const cv::Mat1f& level = pyramid.level(octave, scale);
    const float pixel = std::exp2(static_cast<float>(octave));
    // OpenCV rounds keypoints to pixels of their octave. These points are rounded too, so that both
    // describe the same location. Without rounding, 95 % of the nearest neighbours agree.
    const float x = std::round(point.x / pixel), y = std::round(point.y / pixel);
    const float sigma = point.sigma / pixel;
    const float reach = 11 * sigma;  // the corner of 5 x 5 cells of 3 sigma is 10.6 away
    for (const float angle : sift.orientations(level, x, y, sigma)) {
      result.whole.push_back(std::max(x - level.cols, y - level.rows) + reach < -2);
      sift.describe(level, x, y, sigma, angle, result.ours.emplace_back().data());
      // OpenCV's layers of an octave begin at kSigma, half an octave above this pyramid's.
      const int layer = scale - kSteps / 2 - octave * kSteps;
      const float degrees = static_cast<float>(std::fmod(angle * 180 / CV_PI + 360, 360));
      keypoints.emplace_back(x * pixel, y * pixel, 2 * point.sigma, degrees, 0.0f,
                             octave | (layer << 8));
    }
  }
  cv::Mat descriptors;
  cv::SIFT::create(0, kSteps, 0.04, 10, kSigma)->compute(image, keypoints, descriptors);
  for (int i = 0; i < descriptors.rows; ++i) {
    const float* row = descriptors.ptr<float>(i);
    std::copy_n(row, SiftDescriptor::kDimension, result.theirs.emplace_back().begin());
  }
  return result;
}

std::size_t nearest(const Descriptor& descriptor, const std::vector<Descriptor>& set) {
  const auto distance = [&descriptor](const Descriptor& other) {
    int sum = 0;
    for (std::size_t i = 0; i < other.size(); ++i) {
      sum += (descriptor[i] - other[i]) * (descriptor[i] - other[i]);
    }
    return sum;
  };
  return std::min_element(
             set.begin(), set.end(),
             [&](const Descriptor& a, const Descriptor& b) { return distance(a) < distance(b); }) -
         set.begin();
}

TEST(SiftDescriptor, FindsTheNearestNeighboursThatOpenCvFinds) {
  std::vector<cv::Mat1b> images = realImages(70);
  for (cv::Mat1b& image : images) image = cutToOddOctaves(image);
  if (images.empty()) GTEST_SKIP() << "No images: set PLACE_RECOGNITION_TEST_DATA.";
  int total = 0, agree = 0, whole = 0;
  double distance = 0;
  for (const cv::Mat1b& image : images) {
    cv::Mat1b turned;
    const cv::Point2f middle(image.cols / 2.0f, image.rows / 2.0f);
    cv::warpAffine(image, turned, cv::getRotationMatrix2D(middle, 25, 0.8), image.size(),
                   cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    const Described a = describeBoth(image);
    const Described b = describeBoth(turned);
    ASSERT_EQ(a.ours.size(), a.theirs.size());
    for (std::size_t i = 0; i < a.ours.size(); ++i) {
      agree += nearest(a.ours[i], b.ours) == nearest(a.theirs[i], b.theirs);
      ++total;
      if (!a.whole[i]) continue;
      distance += cv::norm(cv::Mat(a.ours[i]), cv::Mat(a.theirs[i]));
      ++whole;
    }
  }
  std::printf("%d of %d nearest neighbours agree; mean distance of %d %.2f of 512\n", agree, total,
              whole, distance / whole);
  ASSERT_GT(total, 500);
  EXPECT_GE(agree, 0.99 * total);
  ASSERT_GT(whole, 500);
  EXPECT_LT(distance, 0.5 * whole);
}

#else

TEST(SiftDescriptor, FindsTheNearestNeighboursThatOpenCvFinds) {
  GTEST_SKIP() << "This OpenCV has no cv::SIFT; 4.4 and later have.";
}

#endif

}  // namespace
}  // namespace place_recognition
