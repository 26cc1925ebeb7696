// JPEG and PNG images in messages: whole, cut and malicious.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "place_recognition/error.h"
#include "ros/gradient.h"
#include "ros/messages/conversions.h"

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

TEST(CompressedConversions, DeepPngKeepsItsBits) {
  const cv::Mat image(4, 4, CV_16UC1, cv::Scalar(1023));
  const cv::Mat decoded = toImage(compressed(image, ".png"));
  ASSERT_EQ(decoded.type(), CV_16UC1);
  EXPECT_EQ(decoded.at<std::uint16_t>(1, 1), 1023);
}

/// A red image, BGR.
const cv::Mat kRed(16, 16, CV_8UC3, cv::Scalar(20, 40, 200));

/// Returns the strongest channel of the image in a message: 0 to 2 for blue, green, red.
int strongestChannel(const cv::Mat& stored, const std::string& format) {
  sensor_msgs::CompressedImage message =
      compressed(stored, format.find("png") != std::string::npos ? ".png" : ".jpg");
  message.format = format;
  const cv::Scalar mean = cv::mean(toImage(message));
  return static_cast<int>(std::max_element(mean.val, mean.val + 3) - mean.val);
}

TEST(CompressedConversions, RedIsRedWhateverTheFormatSays) {
  cv::Mat swapped;
  cv::cvtColor(kRed, swapped, cv::COLOR_BGR2RGB);
  for (const char* format :
       {"jpeg", "png", "", "rgb8; jpeg compressed bgr8", "bgr8; jpeg compressed bgr8",
        "rgba8; png compressed bgr8", "bgra8; jpeg compressed bgr8", "rgb16; png compressed bgr16",
        "8UC3; jpeg compressed ", "mono8; jpeg compressed "}) {
    EXPECT_EQ(strongestChannel(kRed, format), 2) << format;
  }
  // image_transport's convention: unless the format says BGR, the channels are those of the
  // encoding before the semicolon, RGB.
  for (const char* format :
       {"rgb8; jpeg compressed rgb8", "rgb8; png compressed rgb8", "rgb8; jpeg compressed ",
        "bgr8; jpeg compressed rgb8", "rgba8; jpeg compressed rgb8", "bgra8; png compressed rgb8",
        "rgb16; png compressed rgb16", " RGB8 ; JPEG compressed RGB8"}) {
    EXPECT_EQ(strongestChannel(swapped, format), 2) << format;
  }
}

TEST(CompressedConversions, AMosaicIsColour) {
  // Red, because the upper left of each 2 x 2 pixels is bright and the pattern starts with red.
  cv::Mat mosaic(16, 16, CV_8UC1, cv::Scalar(10));
  for (int row = 0; row < 16; row += 2) {
    for (int col = 0; col < 16; col += 2) mosaic.at<std::uint8_t>(row, col) = 200;
  }
  EXPECT_EQ(strongestChannel(mosaic, "bayer_rggb8; png compressed "), 2);
  EXPECT_EQ(strongestChannel(mosaic, "bayer_bggr8; png compressed "), 0);
  EXPECT_EQ(strongestChannel(mosaic, "bayer_grbg8; png compressed "), 1);
  EXPECT_EQ(strongestChannel(mosaic, "bayer_gbrg8; png compressed "), 1);
}

TEST(CompressedConversions, GreyStaysGrey) {
  sensor_msgs::CompressedImage message = compressed(gradient(CV_8UC1), ".png");
  for (const char* format : {"mono8; png compressed ", "mono8; png compressed mono8", "png"}) {
    message.format = format;
    EXPECT_EQ(toImage(message).type(), CV_8UC1) << format;
  }
}

TEST(CompressedConversions, CutJpegsAreRefused) {
  sensor_msgs::CompressedImage message = compressed(gradient(CV_8UC3), ".jpg");
  message.data.resize(message.data.size() - 30);
  EXPECT_THROW(toImage(message), Error);
}

TEST(CompressedConversions, OtherFormatsAreRefused) {
  EXPECT_THROW(toImage(compressed(gradient(CV_8UC3), ".bmp")), Error);
  EXPECT_THROW(toImage(compressed(gradient(CV_8UC3), ".tiff")), Error);
  EXPECT_NO_THROW(toImage(compressed(gradient(CV_8UC3), ".webp")));
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
  // If TEM were read as a segment, the parser would skip what the decoder reads next.
  const std::vector<std::uint8_t> tem = {0xff, 0x01};
  message.data.insert(message.data.begin() + 2, tem.begin(), tem.end());
  EXPECT_THROW(toImage(message), Error);
}

TEST(CompressedConversions, CutOrChangedImagesDoNotCrash) {
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
