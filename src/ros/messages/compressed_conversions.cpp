#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <string>

#include "base/text.h"
#include "datasets/image_file.h"
#include "place_recognition/error.h"
#include "ros/messages/conversions.h"

namespace place_recognition {
namespace {

namespace encodings = sensor_msgs::image_encodings;

/// The encoding of the decoded pixels if it is neither BGR nor grey, else empty. Follows the rules
/// of compressed_image_transport's subscriber.
std::string encodingOf(std::string format, const cv::Mat& image) {
  format = lowerCase(format.substr(std::min(format.find_first_not_of(' '), format.size())));
  const std::size_t end = format.find(';');
  if (end == std::string::npos) return "";
  const std::string bits = image.depth() == CV_16U ? "16" : "8";
  if (image.channels() == 1) {
    for (const char* pattern : {"bayer_rggb", "bayer_bggr", "bayer_gbrg", "bayer_grbg"}) {
      if (startsWith(format, pattern)) return pattern + bits;
    }
    return "";
  }
  const bool has_colour = startsWith(format, "rgb") || startsWith(format, "bgr");
  const bool stored_as_bgr = format.find("compressed bgr", end) != std::string::npos;
  return has_colour && !stored_as_bgr ? "rgb" + bits : "";
}

cv::Mat toBgr(const cv::Mat& image, const std::string& encoding) {
  const auto source =
      boost::make_shared<const cv_bridge::CvImage>(std_msgs::Header(), encoding, image);
  const bool is_deep = image.depth() == CV_16U;
  return cv_bridge::cvtColor(source, is_deep ? encodings::BGR16 : encodings::BGR8)->image;
}

}  // namespace

cv::Mat toImage(const sensor_msgs::CompressedImage& message) {
  const DecodedImage decoded = decodeImage(message.data.data(), message.data.size());
  if (decoded.image.empty()) throw Error("The compressed image: " + decoded.problem + ".");
  checkImageSize(static_cast<std::uint64_t>(decoded.image.cols),
                 static_cast<std::uint64_t>(decoded.image.rows));
  const std::string encoding = encodingOf(message.format, decoded.image);
  return encoding.empty() ? decoded.image : toBgr(decoded.image, encoding);
}

}  // namespace place_recognition
