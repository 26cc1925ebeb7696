#include "features/edge_density.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace place_recognition {
namespace {

double densityOf(const cv::Mat& image) { return EdgeDensity().of(image); }

/// Returns an image whose grey levels rise by `slope` per pixel.
cv::Mat1b ramp(int slope) {
  cv::Mat1b image(20, 30);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) image(y, x) = static_cast<std::uint8_t>(slope * x);
  }
  return image;
}

TEST(EdgeDensity, OfRampsIsNothingUpToFourLevelsPerPixel) {
  EXPECT_EQ(densityOf(cv::Mat1b(20, 30, 128)), 0);
  EXPECT_EQ(densityOf(ramp(3)), 0);
  EXPECT_EQ(densityOf(ramp(4)), 0);
  // At the sides the ramp meets its own reflection: two columns there have less than 4.
  EXPECT_DOUBLE_EQ(densityOf(ramp(6)), 26.0 / 30);
}

TEST(EdgeDensity, OfAPartOfAnImageIsThatOfItsCopy) {
  cv::Mat1b image(60, 60, static_cast<std::uint8_t>(255));
  cv::Mat1b part = image(cv::Rect(20, 20, 20, 20));
  part.setTo(50);
  EXPECT_EQ(densityOf(part), 0);
}

TEST(EdgeDensity, OfAStepIsFourColumns) {
  // Smoothed, the step is 100 Phi(x). Central differences at half pixels: 34 at 0.5, 16 at 1.5, and
  // 3.3, less than 4, at 2.5.
  cv::Mat1b step(20, 40, static_cast<std::uint8_t>(50));
  step.colRange(20, 40).setTo(150);
  EXPECT_DOUBLE_EQ(densityOf(step), 4.0 / 40);
  cv::Mat colour;
  cv::merge(std::vector<cv::Mat>(3, step), colour);
  EXPECT_DOUBLE_EQ(densityOf(colour), 4.0 / 40);
  EXPECT_DOUBLE_EQ(densityOf(step.t()), 4.0 / 40);
}

}  // namespace
}  // namespace place_recognition
