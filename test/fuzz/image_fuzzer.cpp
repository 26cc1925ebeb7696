// Feeds arbitrary bytes as an image message. The first bytes select a compressed image or the
// fields of a raw image; the pixels follow.

#include <algorithm>
#include <cstring>
#include <opencv2/core.hpp>

#include "place_recognition/error.h"
#include "ros/messages/conversions.h"

using namespace place_recognition;

namespace {

struct Fields {
  std::uint32_t width, height, step;
  std::uint8_t big_endian, encoding;
};

constexpr const char* kEncodings[] = {"bgr8",         "rgb8",        "rgba8",       "mono8",
                                      "mono16",       "bgr16",       "rgba16",      "16UC1",
                                      "bayer_rggb8",  "bayer_bggr8", "bayer_gbrg8", "bayer_grbg16",
                                      "bayer_rggb16", "yuv422",      "yuv422_yuy2"};

sensor_msgs::Image rawImage(const std::uint8_t* data, std::size_t size) {
  Fields fields{};
  const std::size_t head = std::min(size, sizeof(fields));
  std::memcpy(&fields, data, head);
  sensor_msgs::Image message;
  message.width = fields.width;
  message.height = fields.height;
  message.step = fields.step;
  message.is_bigendian = fields.big_endian;
  message.encoding = kEncodings[fields.encoding % std::size(kEncodings)];
  message.data.assign(data + head, data + size);
  return message;
}

template <typename Message>
void use(const Message& message) {
  try {
    const cv::Mat image = toImage(message);
    // Read every pixel, so that access outside the message is detected.
    if (image.empty() || cv::sum(image)[0] < 0) abort();
  } catch (const Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  if (data[0] == 'r') {
    use(rawImage(data + 1, size - 1));
  } else {
    sensor_msgs::CompressedImage message;
    message.data.assign(data + 1, data + size);
    use(message);
  }
  return 0;
}
