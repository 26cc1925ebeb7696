#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>
#include <vector>

#include "reliability/damage.h"

namespace place_recognition {

/// Malformed image messages. The same seed gives the same messages.
class ImageMessages {
 public:
  explicit ImageMessages(unsigned seed) : damage_(images(), seed) {}

  /// Raw images with sizes that wrap, wrong steps, short data, known and unknown encodings, and
  /// NaNs.
  sensor_msgs::Image raw() {
    sensor_msgs::Image message;
    message.encoding = encoding();
    message.is_bigendian = static_cast<std::uint8_t>(damage_.below(2));
    const auto small = [this] { return static_cast<std::uint32_t>(1 + damage_.below(40)); };
    message.width = small();
    message.height = small();
    message.step = message.width * kLargestPixel;
    message.data = bytes(std::size_t{message.step} * message.height);
    for (std::size_t wrong = damage_.below(3); wrong > 0; --wrong) spoil(message);
    return message;
  }

  /// Damaged images in every format that OpenCV writes; some announce huge sizes.
  sensor_msgs::CompressedImage compressed() {
    sensor_msgs::CompressedImage message;
    message.format = "jpeg";
    std::string bytes = damage_.next();
    if (damage_.below(4) == 0) announceHuge(bytes);
    message.data.assign(bytes.begin(), bytes.end());
    return message;
  }

 private:
  static constexpr std::uint32_t kLargestPixel = 16;

  static std::vector<std::string> images() {
    cv::Mat image(18, 24, CV_8UC3);
    cv::randu(image, 0, 255);
    std::vector<std::string> files;
    for (const char* extension : {".png", ".jpg", ".bmp", ".tiff", ".webp", ".ppm"}) {
      std::vector<std::uint8_t> bytes;
      if (cv::haveImageWriter(extension)) cv::imencode(extension, image, bytes);
      files.emplace_back(bytes.begin(), bytes.end());
    }
    return files;
  }

  std::string encoding() {
    static const std::vector<std::string> kEncodings = {"bgr8",
                                                        "rgb8",
                                                        "bgra8",
                                                        "rgba8",
                                                        "mono8",
                                                        "mono16",
                                                        "bgr16",
                                                        "rgba16",
                                                        "8UC1",
                                                        "8UC3",
                                                        "16UC1",
                                                        "bayer_rggb8",
                                                        "bayer_gbrg8",
                                                        "bayer_grbg16",
                                                        "bayer_bggr8",
                                                        "yuv422",
                                                        "yuv422_yuy2",
                                                        "32FC1",
                                                        "32FC3",
                                                        "64FC1",
                                                        "8UC4294967295",
                                                        "nv12",
                                                        "",
                                                        "\xff\xfe"};
    return kEncodings[damage_.below(kEncodings.size())];
  }

  /// Returns bytes that are NaNs as floats.
  std::vector<std::uint8_t> bytes(std::size_t count) {
    std::vector<std::uint8_t> data(count);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = 0; i + sizeof(nan) <= count; i += sizeof(nan)) {
      std::memcpy(&data[i], &nan, sizeof(nan));
    }
    return data;
  }

  void spoil(sensor_msgs::Image& message) {
    static const std::vector<std::uint32_t> kSizes = {
        0,     1,     2,     3,          8191,       8192,       8193,
        65535, 65536, 65537, 0x55555556, 0x7fffffff, 0x80000000, 0xffffffff};
    const std::uint32_t size = kSizes[damage_.below(kSizes.size())];
    switch (damage_.below(4)) {
      case 0:
        message.width = size;
        break;
      case 1:
        message.height = size;
        break;
      case 2:
        message.step = size;
        break;
      default:
        message.data.resize(damage_.below(message.data.size()));
    }
  }

  /// Writes large numbers at the position of width and height in PNG and JPEG.
  void announceHuge(std::string& bytes) {
    const std::size_t frame = bytes.find("\xff\xc0");
    const std::size_t at = frame == std::string::npos ? 16 : frame + 5;
    for (std::size_t i = at; i < std::min(at + 8, bytes.size()); i += 2) bytes[i] = '\x7f';
  }

  Damage damage_;
};

}  // namespace place_recognition
