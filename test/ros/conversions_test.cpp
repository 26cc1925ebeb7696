// Every encoding against hand-made pixels, and malicious messages.

#include "ros/messages/conversions.h"

#include <cv_bridge/cv_bridge.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "error_of.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// A message whose rows have no padding.
sensor_msgs::Image imageMessage(const std::string& encoding, std::uint32_t width,
                                std::uint32_t height, std::vector<std::uint8_t> data) {
  sensor_msgs::Image message;
  message.encoding = encoding;
  message.width = width;
  message.height = height;
  message.step = static_cast<std::uint32_t>(data.size() / height);
  message.data = std::move(data);
  return message;
}

std::vector<std::uint8_t> repeat(const std::vector<std::uint8_t>& bytes, int times) {
  std::vector<std::uint8_t> all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

std::string errorIn(const sensor_msgs::Image& message) {
  return errorOf([&] { toImage(message); });
}

/// Bytes of one pixel (of two pixels in yuv422) whose image is blue 10, green 20, red 30, or grey
/// 40.
struct Case {
  std::string encoding;
  std::vector<std::uint8_t> bytes;
  bool big_endian = false;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.encoding << (c.big_endian ? " big-endian" : "");
}

/// Returns the more significant bytes of an image with 16 bits per channel.
cv::Mat upperBytes(const cv::Mat& image) {
  if (image.depth() != CV_16U) return image;
  cv::Mat upper(image.size(), CV_8UC(image.channels()));
  for (int row = 0; row < image.rows; ++row) {
    for (int i = 0; i < image.cols * image.channels(); ++i) {
      upper.ptr(row)[i] = static_cast<std::uint8_t>(image.ptr<std::uint16_t>(row)[i] / 256);
    }
  }
  return upper;
}

class ColourEncoding : public testing::TestWithParam<Case> {};

TEST_P(ColourEncoding, GivesBlueGreenRed) {
  sensor_msgs::Image message =
      imageMessage(GetParam().encoding, 4, 3, repeat(GetParam().bytes, 12));
  message.is_bigendian = GetParam().big_endian;
  const cv::Mat image = upperBytes(toImage(message));
  ASSERT_EQ(image.type(), CV_8UC3);
  ASSERT_EQ(image.size(), cv::Size(4, 3));
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) EXPECT_EQ(image.at<cv::Vec3b>(y, x), cv::Vec3b(10, 20, 30));
  }
}

INSTANTIATE_TEST_SUITE_P(Conversions, ColourEncoding,
                         testing::Values(Case{"bgr8", {10, 20, 30}}, Case{"8UC3", {10, 20, 30}},
                                         Case{"rgb8", {30, 20, 10}},
                                         Case{"bgra8", {10, 20, 30, 77}},
                                         Case{"rgba8", {30, 20, 10, 77}},
                                         Case{"bgr16", {1, 10, 2, 20, 255, 30}},
                                         Case{"bgr16", {10, 1, 20, 2, 30, 255}, true},
                                         Case{"rgb16", {1, 30, 2, 20, 255, 10}},
                                         Case{"bgra16", {1, 10, 2, 20, 255, 30, 9, 9}},
                                         Case{"rgba16", {30, 1, 20, 2, 10, 255, 9, 9}, true}));

class GreyEncoding : public testing::TestWithParam<Case> {};

TEST_P(GreyEncoding, GivesGrey) {
  sensor_msgs::Image message = imageMessage(GetParam().encoding, 3, 2, repeat(GetParam().bytes, 6));
  message.is_bigendian = GetParam().big_endian;
  const cv::Mat image = upperBytes(toImage(message));
  ASSERT_EQ(image.type(), CV_8UC1);
  ASSERT_EQ(image.size(), cv::Size(3, 2));
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_EQ(image.at<std::uint8_t>(y, x), 40);
  }
}

INSTANTIATE_TEST_SUITE_P(Conversions, GreyEncoding,
                         testing::Values(Case{"mono8", {40}}, Case{"8UC1", {40}},
                                         Case{"mono16", {200, 40}}, Case{"mono16", {40, 200}, true},
                                         Case{"16UC1", {200, 40}}, Case{"16UC1", {40, 200}, true}));

/// Returns the colour at each site of the upper left 2 x 2 pixels.
class BayerEncoding : public testing::TestWithParam<std::string> {};

TEST_P(BayerEncoding, GivesTheColourOfAUniformField) {
  const std::string pattern = GetParam().substr(6, 4);
  const bool deep = GetParam().substr(10) == "16";
  std::vector<std::uint8_t> data;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const char site = pattern[static_cast<std::size_t>((y % 2) * 2 + x % 2)];
      if (deep) data.push_back(123);
      data.push_back(site == 'b' ? 10 : site == 'g' ? 20 : 30);
    }
  }
  const sensor_msgs::Image message = imageMessage(GetParam(), 8, 8, data);
  const cv::Mat image = upperBytes(toImage(message));
  ASSERT_EQ(image.type(), CV_8UC3);
  for (int y = 1; y < 7; ++y) {
    for (int x = 1; x < 7; ++x) EXPECT_EQ(image.at<cv::Vec3b>(y, x), cv::Vec3b(10, 20, 30));
  }
}

INSTANTIATE_TEST_SUITE_P(Conversions, BayerEncoding,
                         testing::Values("bayer_rggb8", "bayer_bggr8", "bayer_gbrg8", "bayer_grbg8",
                                         "bayer_rggb16", "bayer_bggr16", "bayer_gbrg16",
                                         "bayer_grbg16"));

/// ITU-R BT.601 with head room: B = 1.164 (Y - 16) + 2.018 (U - 128), and so on.
cv::Vec3d fromYuv(double y, double u, double v) {
  const double luma = 1.164 * (y - 16);
  return {luma + 2.018 * (u - 128), luma - 0.813 * (v - 128) - 0.391 * (u - 128),
          luma + 1.596 * (v - 128)};
}

void expectYuvPair(const sensor_msgs::Image& message) {
  const cv::Mat image = toImage(message);
  ASSERT_EQ(image.type(), CV_8UC3);
  ASSERT_EQ(image.size(), cv::Size(2, 1));
  for (int x = 0; x < 2; ++x) {
    const cv::Vec3d expected = fromYuv(x == 0 ? 90 : 150, 110, 140);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at<cv::Vec3b>(0, x)[c], expected[c], 1.5);
  }
}

TEST(Conversions, Yuv422IsUyvy) {
  expectYuvPair(imageMessage("yuv422", 2, 1, {110, 90, 140, 150}));
}

TEST(Conversions, Yuv422Yuy2IsYuyv) {
  expectYuvPair(imageMessage("yuv422_yuy2", 2, 1, {90, 110, 150, 140}));
}

TEST(Conversions, PaddedRowsAreRead) {
  const sensor_msgs::Image message = imageMessage("mono8", 2, 2, {1, 2, 99, 99, 3, 4, 99, 99});
  const cv::Mat image = toImage(message);
  EXPECT_EQ(image.at<std::uint8_t>(0, 1), 2);
  EXPECT_EQ(image.at<std::uint8_t>(1, 0), 3);
}

TEST(Conversions, PlainEncodingsShareTheMemoryOfTheMessage) {
  for (const char* encoding : {"bgr8", "mono8"}) {
    const sensor_msgs::Image message = imageMessage(encoding, 4, 4, std::vector<std::uint8_t>(48));
    EXPECT_EQ(toImage(message).data, message.data.data()) << encoding;
  }
}

TEST(Conversions, OnePixelIsAnImage) {
  const sensor_msgs::Image colour = imageMessage("rgb8", 1, 1, {3, 2, 1});
  EXPECT_EQ(toImage(colour).at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
  const sensor_msgs::Image bayer = imageMessage("bayer_rggb8", 1, 1, {3});
  EXPECT_EQ(toImage(bayer).size(), cv::Size(1, 1));
}

/// Reasons for not relying on cv_bridge. If a test is skipped, our own code is no longer needed.
TEST(CvBridge, DoesNotReadBigEndianPixels) {
  sensor_msgs::Image message = imageMessage("mono16", 1, 1, {40, 200});
  message.is_bigendian = true;
  ASSERT_EQ(toImage(message).type(), CV_16UC1);
  const cv::Mat theirs = cv_bridge::toCvCopy(message)->image;
  if (theirs.type() == CV_16UC1) GTEST_SKIP() << "this release of cv_bridge does";
  EXPECT_EQ(theirs.channels(), 2);
}

TEST(CvBridge, DoesNotKnowYuy2) {
  const sensor_msgs::Image message = imageMessage("yuv422_yuy2", 2, 1, {90, 110, 150, 140});
  ASSERT_EQ(toImage(message).type(), CV_8UC3);
  try {
    cv_bridge::toCvCopy(message, "bgr8");
    GTEST_SKIP() << "this release of cv_bridge does";
  } catch (const std::runtime_error&) {
  }
}

TEST(Conversions, BytesBehindTheImageAndALastRowWithoutPaddingDoNoHarm) {
  sensor_msgs::Image message = imageMessage("mono8", 2, 2, {1, 2, 0, 0, 3, 4, 0, 0});
  message.step = 4;
  const cv::Mat whole = toImage(message).clone();
  sensor_msgs::Image longer = message, shorter = message;
  longer.data.resize(20, 255);
  shorter.data.resize(6);
  for (const sensor_msgs::Image& other : {longer, shorter}) {
    EXPECT_EQ(cv::norm(toImage(other), whole, cv::NORM_INF), 0) << other.data.size();
  }
  shorter.data.resize(5);
  EXPECT_THROW(toImage(shorter), Error);
}

TEST(Conversions, SizesThatWrapIn32BitsAreRefused) {
  sensor_msgs::Image message = imageMessage("mono8", 65536, 1, std::vector<std::uint8_t>(65536));
  message.height = 65537;  // 65536 * 65537 = 2^32 + 65536
  EXPECT_NE(errorIn(message).find("65536 x 65537 pixels, more than"), std::string::npos);

  message.width = 8192;
  message.height = 8192;
  message.step = 1u << 19;  // times 8192 is 2^32
  EXPECT_NE(errorIn(message).find("need 4294451200"), std::string::npos) << errorIn(message);

  message = imageMessage("bgr8", 1, 1, {1, 2, 3});
  message.width = 0x55555556;  // times 3 is 2^32 + 2
  EXPECT_NE(errorIn(message), "");
}

TEST(Conversions, MessagesThatDoNotAgreeAreRefused) {
  const sensor_msgs::Image good = imageMessage("bgr8", 4, 4, std::vector<std::uint8_t>(48));
  sensor_msgs::Image message = good;
  message.width = 0;
  EXPECT_NE(errorIn(message).find("empty"), std::string::npos);
  message = good;
  message.height = 0;
  EXPECT_NE(errorIn(message).find("empty"), std::string::npos);
  message = good;
  message.step = 11;
  EXPECT_NE(errorIn(message).find("too short for 4 pixels"), std::string::npos);
  message = good;
  message.step = 0;
  EXPECT_NE(errorIn(message), "");
  message = good;
  message.data.resize(47);
  EXPECT_NE(errorIn(message).find("47 bytes"), std::string::npos);
  message = good;
  message.data.clear();
  EXPECT_NE(errorIn(message), "");
}

TEST(Conversions, UnknownEncodingsAreRefusedByName) {
  EXPECT_NE(errorIn(imageMessage("nv12", 2, 2, std::vector<std::uint8_t>(6))).find("'nv12'"),
            std::string::npos);
  EXPECT_NE(errorIn(imageMessage("32FC1", 1, 1, {0, 0, 0xc0, 0x7f})).find("'32FC1'"),
            std::string::npos);
  EXPECT_LT(errorIn(imageMessage(std::string(1 << 20, 'x'), 1, 1, {1})).size(), 600u);
  EXPECT_NE(errorIn(imageMessage("", 1, 1, {1})), "");
  EXPECT_NE(errorIn(imageMessage(std::string("bo\0bo", 5), 1, 1, {1})).find("'bo?bo'"),
            std::string::npos);
}

TEST(Conversions, OddWidthsOfYuvAreRefused) {
  EXPECT_NE(errorIn(imageMessage("yuv422", 3, 1, {1, 2, 3, 4, 5, 6})).find("odd width"),
            std::string::npos);
}

TEST(Conversions, NoMessageCrashes) {
  std::mt19937 random(7);
  const std::vector<std::string> encodings = {"bgr8",   "rgba16",      "mono16",      "bayer_gbrg8",
                                              "yuv422", "yuv422_yuy2", "bayer_rggb16"};
  const std::vector<std::uint32_t> sizes = {0,    1,     2,     3,          5,
                                            8192, 65536, 65537, 0x80000000, 0xffffffff};
  int images = 0;
  for (int i = 0; i < 20000; ++i) {
    sensor_msgs::Image message;
    message.encoding = encodings[random() % encodings.size()];
    message.width = sizes[random() % sizes.size()];
    message.height = sizes[random() % sizes.size()];
    message.step = random() % 2 ? sizes[random() % sizes.size()] : 8 * message.width;
    message.is_bigendian = static_cast<std::uint8_t>(random());
    const std::uint64_t whole = std::uint64_t{message.step} * message.height;
    message.data.resize(whole < 1000 && random() % 2 ? whole : random() % 100);
    try {
      const cv::Mat image = toImage(message);
      ++images;
      ASSERT_TRUE(image.channels() == 3 || image.channels() == 1);
      ASSERT_EQ(image.cols, static_cast<int>(message.width));
      ASSERT_EQ(image.rows, static_cast<int>(message.height));
    } catch (const Error&) {
    }
  }
  EXPECT_GT(images, 100);
}

}  // namespace
}  // namespace place_recognition
