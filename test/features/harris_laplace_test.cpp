#include "features/harris_laplace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "features/local_images.h"

namespace place_recognition {
namespace {

HarrisLaplace::Options options() { return {2, 4, 5, 0.05, 100, 5}; }

std::vector<InterestPoint> detect(const cv::Mat1f& image, std::size_t limit = 1000) {
  return HarrisLaplace(options()).detect(image, limit);
}

bool isEqual(const InterestPoint& a, const InterestPoint& b) {
  return a.x == b.x && a.y == b.y && a.sigma == b.sigma && a.cornerness == b.cornerness;
}

class BlobTest : public testing::TestWithParam<double> {};

// The Laplacian of a Gaussian blob of variance t0, at its middle, is proportional to
// t / (t0 + t)^2: largest at t = t0.
TEST_P(BlobTest, HasItsPlaceAndScale) {
  const double sigma = GetParam();
  const cv::Point2d middle(120.3, 98.6);
  cv::Mat1f image(200, 240);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double square = std::pow(x - middle.x, 2) + std::pow(y - middle.y, 2);
      image(y, x) = static_cast<float>(200 - 150 * std::exp(-square / (2 * sigma * sigma)));
    }
  }
  const std::vector<InterestPoint> points = detect(image);
  ASSERT_FALSE(points.empty());
  EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                          [&](const InterestPoint& p) {
                            return std::hypot(p.x - middle.x, p.y - middle.y) < 0.1 * sigma &&
                                   std::abs(p.sigma / sigma - 1) < 0.05;
                          }))
      << "strongest: " << points[0].x << ", " << points[0].y << " sigma " << points[0].sigma;
}

INSTANTIATE_TEST_SUITE_P(Scales, BlobTest, testing::Values(2.2, 3, 5, 8, 13));

// The maximum of the cornerness lies on a corner's diagonal, a little inside.
TEST(HarrisLaplace, FindsTheCornersOfASquare) {
  cv::Mat1f image(100, 100, 50.0f);
  image(cv::Rect(30, 40, 40, 30)) = 150;  // between the pixel edges 29.5, 69.5 and 39.5, 69.5
  const std::vector<InterestPoint> points = detect(image);
  for (const double x : {29.5, 69.5}) {
    for (const double y : {39.5, 69.5}) {
      EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                              [&](const InterestPoint& p) {
                                const double inside_x = x < 50 ? p.x - x : x - p.x;
                                const double inside_y = y < 50 ? p.y - y : y - p.y;
                                return p.sigma < 3 && inside_x > 0 && inside_x < 1.5 * p.sigma &&
                                       std::abs(inside_x - inside_y) < 0.01;
                              }))
          << x << ", " << y;
    }
  }
}

TEST(HarrisLaplace, FindsNothingInBlanksEdgesAndFaintNoise) {
  EXPECT_TRUE(detect(cv::Mat1f(100, 120, 128.0f)).empty());

  cv::Mat1f edge(100, 120, 20.0f);
  edge(cv::Rect(0, 0, 50, 100)) = 220;
  EXPECT_TRUE(detect(edge).empty());

  cv::Mat1f noise(200, 200);
  cv::RNG(3).fill(noise, cv::RNG::NORMAL, 128, 2);
  EXPECT_TRUE(detect(noise).empty());
}

TEST(HarrisLaplace, TakesImagesOfAnySize) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(8, 8), cv::Size(9, 9),
                              cv::Size(11, 200), cv::Size(24, 25), cv::Size(333, 51)}) {
    for (const InterestPoint& p : detect(texture(size.width, size.height, 5))) {
      EXPECT_TRUE(p.x >= 3 && p.y >= 3 && p.x <= size.width - 3 && p.y <= size.height - 3) << size;
    }
  }
}

TEST(HarrisLaplace, IgnoresBrightnessAndScalesWithContrast) {
  const cv::Mat1f image = texture(200, 160, 2) * 0.25;
  const std::vector<InterestPoint> points = detect(image);
  const std::vector<InterestPoint> brighter = detect(image + 100);
  ASSERT_GT(points.size(), 20u);
  EXPECT_NEAR(points.size(), brighter.size(), 0.02 * points.size());

  // Powers of two do not affect rounding.
  HarrisLaplace::Options stricter = options();
  stricter.cornerness_threshold *= 16;
  stricter.laplacian_threshold *= 2;
  const std::vector<InterestPoint> doubled = HarrisLaplace(stricter).detect(image * 2, 1000);
  ASSERT_EQ(points.size(), doubled.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].x, doubled[i].x);
    EXPECT_EQ(points[i].sigma, doubled[i].sigma);
    EXPECT_EQ(16 * points[i].cornerness, doubled[i].cornerness);
  }
}

// A quarter turn keeps the pixel grid and that of every octave.
TEST(HarrisLaplace, TurnsWithTheImage) {
  const cv::Mat1f image = texture(262, 257, 4);
  cv::Mat1f turned;
  cv::rotate(image, turned, cv::ROTATE_90_CLOCKWISE);
  const std::vector<InterestPoint> points = detect(image);
  const std::vector<InterestPoint> turned_points = detect(turned);
  ASSERT_GT(points.size(), 100u);
  std::size_t found = 0;
  for (const InterestPoint& p : points) {
    found += std::any_of(turned_points.begin(), turned_points.end(), [&p](const InterestPoint& q) {
      return std::hypot(q.x - (256 - p.y), q.y - p.x) < 0.02 &&
             std::abs(q.sigma / p.sigma - 1) < 0.005 &&
             std::abs(q.cornerness / p.cornerness - 1) < 0.001;
    });
  }
  EXPECT_GT(found, 0.99 * points.size());
}

TEST(HarrisLaplace, GivesTheStrongestFirstAndTheSameEveryTime) {
  const cv::Mat1f image = texture(300, 200, 6);
  HarrisLaplace detector(options());
  const std::vector<InterestPoint> all = detector.detect(image, 10000);
  ASSERT_GT(all.size(), 50u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GE(all[i - 1].cornerness, all[i].cornerness);
  }
  detector.detect(texture(123, 77, 7), 10000);  // leaves other sizes in its buffers
  const std::vector<InterestPoint> few = detector.detect(image, 20);
  ASSERT_EQ(few.size(), 20u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), all.begin(), isEqual));
  const std::vector<InterestPoint> again = detect(image, 20);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), again.begin(), again.end(), isEqual));
}

TEST(HarrisLaplace, GivesNoPointTwice) {
  const std::vector<InterestPoint> points = detect(texture(300, 200, 8));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const InterestPoint &p = points[i], &q = points[j];
      const double smaller = std::min(p.sigma, q.sigma);
      EXPECT_FALSE(std::hypot(p.x - q.x, p.y - q.y) < 0.999 * smaller &&
                   std::max(p.sigma, q.sigma) < 1.299 * smaller);
    }
  }
}

}  // namespace
}  // namespace place_recognition
