#include "ros/messages/conversions.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <string>
#include <string_view>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr int kAsIs = -1;

/// How the pixels of an encoding lie in memory, and what makes BGR or grey of them.
struct Encoding {
  std::string_view name;
  int channels;
  int bytes;       ///< a channel
  int conversion;  ///< of cv::cvtColor, or kAsIs
};

// OpenCV names a Bayer pattern by its second row, ROS by its first.
constexpr std::array<Encoding, 23> kEncodings{{
    {"bgr8", 3, 1, kAsIs},
    {"8UC3", 3, 1, kAsIs},
    {"mono8", 1, 1, kAsIs},
    {"8UC1", 1, 1, kAsIs},
    {"rgb8", 3, 1, cv::COLOR_RGB2BGR},
    {"bgra8", 4, 1, cv::COLOR_BGRA2BGR},
    {"rgba8", 4, 1, cv::COLOR_RGBA2BGR},
    {"mono16", 1, 2, kAsIs},
    {"16UC1", 1, 2, kAsIs},
    {"bgr16", 3, 2, kAsIs},
    {"rgb16", 3, 2, cv::COLOR_RGB2BGR},
    {"bgra16", 4, 2, cv::COLOR_BGRA2BGR},
    {"rgba16", 4, 2, cv::COLOR_RGBA2BGR},
    {"bayer_rggb8", 1, 1, cv::COLOR_BayerBG2BGR},
    {"bayer_bggr8", 1, 1, cv::COLOR_BayerRG2BGR},
    {"bayer_gbrg8", 1, 1, cv::COLOR_BayerGR2BGR},
    {"bayer_grbg8", 1, 1, cv::COLOR_BayerGB2BGR},
    {"bayer_rggb16", 1, 2, cv::COLOR_BayerBG2BGR},
    {"bayer_bggr16", 1, 2, cv::COLOR_BayerRG2BGR},
    {"bayer_gbrg16", 1, 2, cv::COLOR_BayerGR2BGR},
    {"bayer_grbg16", 1, 2, cv::COLOR_BayerGB2BGR},
    {"yuv422", 2, 1, cv::COLOR_YUV2BGR_UYVY},
    {"yuv422_yuy2", 2, 1, cv::COLOR_YUV2BGR_YUY2},
}};

const Encoding& findEncoding(const std::string& name) {
  const auto found = std::find_if(kEncodings.begin(), kEncodings.end(),
                                  [&name](const Encoding& e) { return e.name == name; });
  if (found != kEncodings.end()) return *found;
  std::string known;
  for (const Encoding& encoding : kEncodings)
    known += (known.empty() ? "" : ", ") + std::string(encoding.name);
  throw Error("Images of encoding '" + name.substr(0, 40) + "' cannot be used; known are " + known +
              ".");
}

std::string sizeText(std::uint64_t width, std::uint64_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// Throws unless the message holds what it claims; in 64 bits, for step * height wraps in 32.
void checkData(const sensor_msgs::Image& message, const Encoding& encoding) {
  const std::uint64_t row_bytes = std::uint64_t{message.width} * encoding.channels * encoding.bytes;
  if (message.step < row_bytes) {
    throw Error("The image's rows of " + std::to_string(message.step) +
                " bytes are too short for " + std::to_string(message.width) + " pixels of " +
                message.encoding + ".");
  }
  if (encoding.channels == 2 && message.width % 2 != 0) {
    throw Error("The image of " + message.encoding + " has an odd width, though two pixels share " +
                "their colour.");
  }
  const std::uint64_t needed = std::uint64_t{message.step} * (message.height - 1) + row_bytes;
  if (message.data.size() < needed) {
    throw Error("The image has " + std::to_string(message.data.size()) + " bytes where " +
                sizeText(message.width, message.height) + " pixels of " + message.encoding +
                " need " + std::to_string(needed) + ".");
  }
}

cv::Mat withSwappedBytes(const cv::Mat& image) {
  cv::Mat swapped(image.size(), image.type());
  for (int row = 0; row < image.rows; ++row) {
    const auto* from = image.ptr<std::uint16_t>(row);
    auto* to = swapped.ptr<std::uint16_t>(row);
    for (int i = 0; i < image.cols * image.channels(); ++i) {
      to[i] = static_cast<std::uint16_t>(from[i] << 8 | from[i] >> 8);
    }
  }
  return swapped;
}

cv::Mat convert(const sensor_msgs::Image& message, const Encoding& encoding) {
  // The const_cast is safe: the picture is only read.
  cv::Mat image(static_cast<int>(message.height), static_cast<int>(message.width),
                CV_MAKETYPE(encoding.bytes == 2 ? CV_16U : CV_8U, encoding.channels),
                const_cast<std::uint8_t*>(message.data.data()), message.step);
  if (encoding.bytes == 2 && message.is_bigendian) image = withSwappedBytes(image);
  if (encoding.conversion == kAsIs) return image;
  cv::Mat converted;
  cv::cvtColor(image, converted, encoding.conversion);
  return converted;
}

std::string featureText(const CueOptions& cue) {
  const std::string type =
      std::visit([](const auto& feature) { return std::string(feature.kType); }, cue.feature);
  return cue.name + ": " + type + ", " + cue.kernel.type + " kernel";
}

}  // namespace

void checkImageSize(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) {
    throw Error("The image is empty (" + sizeText(width, height) + " pixels).");
  }
  if (width > kMaxImageSide || height > kMaxImageSide) {
    throw Error("The image claims " + sizeText(width, height) + " pixels, more than " +
                sizeText(kMaxImageSide, kMaxImageSide) + ".");
  }
}

cv::Mat toImage(const sensor_msgs::Image& message) {
  const Encoding& encoding = findEncoding(message.encoding);
  checkImageSize(message.width, message.height);
  checkData(message, encoding);
  cv::Mat image;
  try {
    image = convert(message, encoding);
  } catch (const std::exception& e) {
    throw Error("The image of " + sizeText(message.width, message.height) + " pixels of " +
                message.encoding + " cannot be converted: " + e.what());
  }
  if (image.empty() || (image.channels() != 3 && image.channels() != 1)) {
    throw Error("The image of encoding " + message.encoding + " cannot be converted.");
  }
  return image;
}

PlaceRecognition toPlaceRecognition(const Recognition& recognition, const Model& model,
                                    const std_msgs::Header& header, double seconds) {
  PlaceRecognition message;
  message.header = header;
  message.model_name = model.name;
  message.model_version = model.version;
  if (recognition.place >= 0) {
    message.place = model.places[static_cast<std::size_t>(recognition.place)];
  }
  message.known = recognition.known;
  message.confidence = recognition.confidence;
  message.evidence = recognition.evidence;
  message.reason = recognition.reason;
  message.places.resize(model.places.size());
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    message.places[i].name = model.places[i];
    message.places[i].probability = recognition.probabilities[static_cast<Eigen::Index>(i)];
    message.places[i].margin = recognition.margins[static_cast<Eigen::Index>(i)];
  }
  message.seconds = seconds;
  return message;
}

ModelInfo toModelInfo(const Model& model) {
  ModelInfo message;
  message.name = model.name;
  message.version = model.version;
  message.places = model.places;
  for (const CueOptions& cue : model.options.cues) message.features.push_back(featureText(cue));
  message.support_vectors = static_cast<std::uint32_t>(model.supportVectorCount());
  return message;
}

sensor_msgs::Image toImageMessage(const cv::Mat& image, const std_msgs::Header& header) {
  const cv::Mat pixels = image.isContinuous() ? image : image.clone();
  sensor_msgs::Image message;
  message.header = header;
  message.height = static_cast<std::uint32_t>(pixels.rows);
  message.width = static_cast<std::uint32_t>(pixels.cols);
  message.encoding = pixels.channels() == 3 ? "bgr8" : "mono8";
  message.step = static_cast<std::uint32_t>(pixels.cols * pixels.elemSize());
  message.data.assign(pixels.datastart, pixels.dataend);
  return message;
}

}  // namespace place_recognition
