#include "recognition/frames/image_scaling.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "recognition/drawn_recording.h"

namespace place_recognition {
namespace {

/// Noise whose amplitude falls with frequency, as in photographs.
cv::Mat texture(int width, int height, int type) {
  cv::Mat sum = cv::Mat::zeros(height, width, CV_MAKETYPE(CV_32F, CV_MAT_CN(type)));
  cv::RNG random(7);
  for (double sigma = 0.4; sigma < 20; sigma *= 2) {
    cv::Mat octave(sum.size(), sum.type());
    random.fill(octave, cv::RNG::NORMAL, 0, 30 * sigma);
    cv::GaussianBlur(octave, octave, {}, sigma);
    sum += octave;
  }
  cv::Mat image;
  sum.convertTo(image, type, 1.2, 128);
  return image;
}

cv::Mat shrunk(const cv::Mat& image, double factor) {
  cv::Mat small;
  cv::resize(image, small, {}, factor, factor, cv::INTER_AREA);
  return small;
}

/// Returns the image without its border, where pixels lack neighbours.
cv::Mat interior(const cv::Mat& image) {
  return image(cv::Rect(6, 6, image.cols - 12, image.rows - 12));
}

double meanDifference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(interior(a), interior(b), cv::NORM_L1) /
         static_cast<double>(interior(a).total() * static_cast<std::size_t>(a.channels()));
}

/// Returns the mean |Laplacian| at t = 1.
double detail(const cv::Mat& image) {
  cv::Mat smooth, laplacian;
  cv::GaussianBlur(image, smooth, {}, 1);
  cv::Laplacian(smooth, laplacian, CV_32F);
  return cv::norm(interior(laplacian), cv::NORM_L1) /
         static_cast<double>(interior(laplacian).total());
}

TEST(Enlarged, MeansOverPixelsAreThePixelsAgain) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat small = texture(80, 60, type);
    for (const int factor : {2, 3, 4}) {
      const cv::Mat large = enlarged(small, small.size() * factor);
      EXPECT_EQ(large.type(), type);
      const double difference = meanDifference(shrunk(large, 1.0 / factor), small);
      EXPECT_LT(difference, 1) << factor;
      cv::Mat interpolated;
      cv::resize(small, interpolated, large.size(), 0, 0, cv::INTER_CUBIC);
      EXPECT_GT(meanDifference(shrunk(interpolated, 1.0 / factor), small), 3 * difference);
    }
  }
}

TEST(ImageScaler, ShrinkingALittleDoesNotBlur) {
  const cv::Mat room = texture(800, 600, CV_8UC3);
  const cv::Mat image = shrunk(room, 0.2), large = shrunk(room, 0.25);
  ImageProfile trained;
  trained.width = image.cols;
  trained.height = image.rows;
  cv::Mat plain;
  cv::resize(large, plain, image.size(), 0, 0, cv::INTER_AREA);
  EXPECT_LT(meanDifference(ImageScaler(trained, 0).scaled(large), image),
            meanDifference(plain, image));
}

TEST(Enlarged, KeepsWhatDerivativesSeeInTheOriginal) {
  const cv::Mat original = texture(320, 240, CV_8UC1);
  for (const double factor : {0.5, 0.75}) {
    const cv::Mat small = shrunk(original, factor);
    EXPECT_NEAR(detail(enlarged(small, original.size())) / detail(original), 1, 0.12) << factor;
  }
}

TEST(Enlarged, AUniformImageStaysUniform) {
  const cv::Mat large = enlarged(cv::Mat(10, 14, CV_8UC3, cv::Scalar(10, 200, 255)), {33, 21});
  EXPECT_EQ(cv::norm(large, cv::Mat(21, 33, CV_8UC3, cv::Scalar(10, 200, 255)), cv::NORM_INF), 0);
}

TEST(Enlarged, AreasOfAnImageAreEnlargedAsTheirCopies) {
  const cv::Mat image = texture(60, 50, CV_8UC3);
  const cv::Mat area = image(cv::Rect(20, 10, 24, 32));
  const cv::Mat large = enlarged(area, {36, 48});
  EXPECT_EQ(cv::norm(large, enlarged(area.clone(), {36, 48}), cv::NORM_INF), 0);
}

ImageProfile trainedOn(int width, int height) {
  ImageProfile profile;
  profile.width = width;
  profile.height = height;
  return profile;
}

TEST(ImageScaler, TheLongerSideBecomesThatOfTheTrainingImages) {
  const ImageScaler scaler(trainedOn(640, 480), 640);
  EXPECT_EQ(scaler.sizeFor({640, 480}), cv::Size(640, 480));
  EXPECT_EQ(scaler.sizeFor({1280, 960}), cv::Size(640, 480));
  EXPECT_EQ(scaler.sizeFor({320, 240}), cv::Size(640, 480));
  EXPECT_EQ(scaler.sizeFor({1280, 720}), cv::Size(640, 360));
  EXPECT_EQ(scaler.sizeFor({480, 640}), cv::Size(480, 640));
  EXPECT_EQ(scaler.sizeFor({64, 48}), cv::Size(256, 192));  // at most fourfold
}

TEST(ImageScaler, TrainingImagesKeepToTheGreatestWidth) {
  const ImageScaler scaler(trainedOn(1280, 960), 640);
  EXPECT_EQ(scaler.sizeFor({1280, 960}), cv::Size(640, 480));
  EXPECT_EQ(scaler.sizeFor({640, 480}), cv::Size(640, 480));
  EXPECT_EQ(ImageScaler(trainedOn(1280, 960), 0).sizeFor({640, 480}), cv::Size(1280, 960));
}

TEST(ImageScaler, OfAnUnknownSizeOnlyWideImagesAreScaled) {
  const ImageScaler scaler({}, 640);
  EXPECT_EQ(scaler.sizeFor({1280, 960}), cv::Size(640, 480));
  EXPECT_EQ(scaler.sizeFor({320, 240}), cv::Size(320, 240));
}

TEST(ImageScaler, WhatTheTrainingScaledDownIsInterpolated) {
  const cv::Mat image = texture(80, 60, CV_8UC3);
  cv::Mat expected;
  cv::resize(image, expected, {64, 48}, 0, 0, cv::INTER_LINEAR);
  EXPECT_EQ(cv::norm(ImageScaler(trainedOn(80, 60), 64).scaled(image), expected, cv::NORM_INF), 0);
  EXPECT_NE(cv::norm(ImageScaler(trainedOn(64, 48), 64).scaled(image), expected, cv::NORM_INF), 0)
      << "as a camera of the size that was trained on shows it";
  cv::resize(image, expected, {32, 24}, 0, 0, cv::INTER_AREA);
  EXPECT_EQ(cv::norm(ImageScaler(trainedOn(80, 60), 32).scaled(image), expected, cv::NORM_INF), 0);
}

TEST(ImageScaler, ReturnsAnImageOfTheRightSizeItself) {
  ImageScaler scaler(trainedOn(96, 72), 640);
  const cv::Mat image = drawRoom(0, 1);
  EXPECT_EQ(scaler.scaled(image).data, image.data);
  EXPECT_EQ(scaler.scaled(shrunk(image, 0.5)).size(), image.size());
}

}  // namespace
}  // namespace place_recognition
