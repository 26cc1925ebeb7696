// JPEG and PNG pictures in messages, whole, cut and made by an enemy.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>
#include <vector>

#include "place_recognition/error.h"
#include "ros/conversions.h"
#include "ros/gradient.h"

namespace place_recognition {
namespace {

sensor_msgs::CompressedImage compressed(const cv::Mat& image, const std::string& extension) {
  sensor_msgs::CompressedImage message;
  cv::imencode(extension, image, message.data);
  return message;
}

TEST(CompressedConversions, PngIsExact) {
  for (const int type : {CV_8UC3, CV_8UC1}) {
    const cv::Mat image = gradient(type);
    const cv::Mat decoded = toImage(compressed(image, ".png"));
    ASSERT_EQ(decoded.type(), type);
    EXPECT_EQ(cv::norm(image, decoded, cv::NORM_INF), 0);
  }
}

TEST(CompressedConversions, JpegIsClose) {
  for (const int type : {CV_8UC3, CV_8UC1}) {
    const cv::Mat image = gradient(type);
    const cv::Mat decoded = toImage(compressed(image, ".jpg"));
    ASSERT_EQ(decoded.type(), type);
    EXPECT_LE(cv::norm(image, decoded, cv::NORM_INF), 16);
  }
}

TEST(CompressedConversions, DeepPngBecomesEightBits) {
  const cv::Mat image(4, 4, CV_16UC1, cv::Scalar(40 * 257));
  const cv::Mat decoded = toImage(compressed(image, ".png"));
  ASSERT_EQ(decoded.type(), CV_8UC1);
  EXPECT_EQ(decoded.at<std::uint8_t>(1, 1), 40);
}

TEST(CompressedConversions, OtherFormatsAreRefused) {
  EXPECT_THROW(toImage(compressed(gradient(CV_8UC3), ".bmp")), Error);
  EXPECT_THROW(toImage(compressed(gradient(CV_8UC3), ".tiff")), Error);
  EXPECT_THROW(toImage(sensor_msgs::CompressedImage()), Error);
}

TEST(CompressedConversions, BombsAreRefusedByTheirHeader) {
  sensor_msgs::CompressedImage png = compressed(gradient(CV_8UC3), ".png");
  for (const std::size_t offset : {16, 20}) png.data[offset + 2] = 0xea;  // about 60,000 each
  EXPECT_THROW(toImage(png), Error);

  sensor_msgs::CompressedImage jpeg = compressed(gradient(CV_8UC3), ".jpg");
  const std::vector<std::uint8_t> frame = {0xff, 0xc0};
  const auto found = std::search(jpeg.data.begin(), jpeg.data.end(), frame.begin(), frame.end());
  ASSERT_NE(found, jpeg.data.end());
  std::fill(found + 5, found + 9, 0xfe);
  EXPECT_THROW(toImage(jpeg), Error);
}

TEST(CompressedConversions, MarkersWithoutLengthDoNotHideTheSize) {
  sensor_msgs::CompressedImage message = compressed(gradient(CV_8UC3), ".jpg");
  // Read as a segment, TEM would jump over what the decoder reads next.
  const std::vector<std::uint8_t> tem = {0xff, 0x01};
  message.data.insert(message.data.begin() + 2, tem.begin(), tem.end());
  EXPECT_THROW(toImage(message), Error);
}

TEST(CompressedConversions, CutOrChangedPicturesDoNotCrash) {
  std::mt19937 random(3);
  for (const std::string extension : {".png", ".jpg"}) {
    const sensor_msgs::CompressedImage good = compressed(gradient(CV_8UC3), extension);
    for (int i = 0; i < 2000; ++i) {
      sensor_msgs::CompressedImage message = good;
      if (i % 2 == 0) {
        message.data.resize(random() % good.data.size());
      } else {
        for (int k = 0; k < 3; ++k) {
          message.data[random() % message.data.size()] = static_cast<std::uint8_t>(random());
        }
      }
      try {
        const cv::Mat image = toImage(message);
        ASSERT_TRUE(image.type() == CV_8UC3 || image.type() == CV_8UC1);
      } catch (const Error&) {
      }
    }
  }
}

}  // namespace
}  // namespace place_recognition
