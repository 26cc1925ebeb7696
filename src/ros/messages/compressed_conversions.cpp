#include <opencv2/imgproc.hpp>
#include <string>

#include "datasets/image_file.h"
#include "place_recognition/error.h"
#include "ros/messages/conversions.h"

namespace place_recognition {
namespace {

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// What makes BGR of a picture as it was decoded, of cv::cvtColor, or -1 for none; the rules of
/// compressed_image_transport's subscriber.
int conversionOf(const std::string& format, int channels) {
  const std::size_t end = format.find(';');
  if (end == std::string::npos) return -1;
  const std::string encoding = format.substr(0, end);
  if (channels == 1) {
    // OpenCV names a Bayer pattern by its second row, ROS by its first.
    if (startsWith(encoding, "bayer_rggb")) return cv::COLOR_BayerBG2BGR;
    if (startsWith(encoding, "bayer_bggr")) return cv::COLOR_BayerRG2BGR;
    if (startsWith(encoding, "bayer_gbrg")) return cv::COLOR_BayerGR2BGR;
    if (startsWith(encoding, "bayer_grbg")) return cv::COLOR_BayerGB2BGR;
    return -1;
  }
  const bool has_colour = startsWith(encoding, "rgb") || startsWith(encoding, "bgr");
  const bool stored_as_bgr = format.find("compressed bgr", end) != std::string::npos;
  return has_colour && !stored_as_bgr ? cv::COLOR_RGB2BGR : -1;
}

}  // namespace

cv::Mat toImage(const sensor_msgs::CompressedImage& message) {
  const DecodedImage decoded = decodeImage(message.data.data(), message.data.size());
  if (decoded.image.empty()) throw Error("The compressed image: " + decoded.problem + ".");
  checkImageSize(static_cast<std::uint64_t>(decoded.image.cols),
                 static_cast<std::uint64_t>(decoded.image.rows));
  const int conversion = conversionOf(message.format, decoded.image.channels());
  if (conversion < 0) return decoded.image;
  cv::Mat converted;
  cv::cvtColor(decoded.image, converted, conversion);
  return converted;
}

}  // namespace place_recognition
