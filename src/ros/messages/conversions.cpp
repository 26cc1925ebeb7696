#include "ros/messages/conversions.h"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "base/text.h"
#include "place_recognition/error.h"
#include "recognition/over_time/room_answer.h"

namespace place_recognition {
namespace {

namespace encodings = sensor_msgs::image_encodings;

/// YUYV, which UVC cameras send. Only some releases of cv_bridge and sensor_msgs support it.
const char* const kYuy2 = "yuv422_yuy2";

bool isGrey(const std::string& encoding) {
  return encodings::isMono(encoding) || encoding == encodings::TYPE_8UC1 ||
         encoding == encodings::TYPE_16UC1;
}

bool isColor(const std::string& encoding) {
  return encodings::isColor(encoding) || encodings::isBayer(encoding) ||
         encoding == encodings::TYPE_8UC3 || encoding == encodings::YUV422;
}

/// Layout of the pixels of an encoding in memory.
struct PixelLayout {
  std::uint64_t channels;
  std::uint64_t bytes;  ///< per channel
};

PixelLayout layoutOf(const std::string& encoding) {
  if (encoding == kYuy2) return {2, 1};
  if (!isGrey(encoding) && !isColor(encoding)) {
    throw Error(
        "Images of encoding " + inQuotes(encoding, 40) +
        " cannot be used; supported are rgb, bgr, rgba, bgra, mono and bayer of 8 or 16 bits, "
        "yuv422, yuv422_yuy2, 8UC1, 8UC3 and 16UC1.");
  }
  return {static_cast<std::uint64_t>(encodings::numChannels(encoding)),
          static_cast<std::uint64_t>(encodings::bitDepth(encoding)) / 8};
}

/// Bytes of a row without its padding.
std::uint64_t rowBytes(const sensor_msgs::Image& message, const PixelLayout& layout) {
  return message.width * layout.channels * layout.bytes;
}

/// Throws unless the message contains the data that it claims. Uses 64 bits, because step * height
/// can overflow in 32, which cv_bridge does not check.
void checkData(const sensor_msgs::Image& message, const PixelLayout& layout) {
  const std::uint64_t row_bytes = rowBytes(message, layout);
  if (message.step < row_bytes) {
    throw Error("The image's rows of " + std::to_string(message.step) +
                " bytes are too short for " + std::to_string(message.width) + " pixels of " +
                message.encoding + ".");
  }
  if (layout.channels == 2 && message.width % 2 != 0) {
    throw Error("The image of " + message.encoding +
                " has an odd width, although two pixels share " + "their colour.");
  }
  const std::uint64_t needed = std::uint64_t{message.step} * (message.height - 1) + row_bytes;
  if (message.data.size() < needed) {
    throw Error("The image has " + std::to_string(message.data.size()) + " bytes, but " +
                sizeText(message.width, message.height) + " pixels of " + message.encoding +
                " need " + std::to_string(needed) + ".");
  }
}

/// The image without padding: cv_bridge requires step * height bytes, but cameras omit the padding
/// of the last row or send more bytes.
sensor_msgs::Image packed(const sensor_msgs::Image& message, std::uint64_t row_bytes) {
  sensor_msgs::Image copy;
  copy.header = message.header;
  copy.height = message.height;
  copy.width = message.width;
  copy.encoding = message.encoding;
  copy.is_bigendian = message.is_bigendian;
  copy.step = static_cast<std::uint32_t>(row_bytes);
  copy.data.reserve(row_bytes * message.height);
  for (std::uint64_t row = 0; row < message.height; ++row) {
    const auto begin = message.data.begin() + static_cast<std::ptrdiff_t>(row * message.step);
    copy.data.insert(copy.data.end(), begin, begin + static_cast<std::ptrdiff_t>(row_bytes));
  }
  return copy;
}

/// cv_bridge 1.16.2 converts each big-endian channel of 16 bits to two of 8 bits.
sensor_msgs::Image littleEndian(sensor_msgs::Image message) {
  for (std::size_t i = 0; i + 1 < message.data.size(); i += 2) {
    std::swap(message.data[i], message.data[i + 1]);
  }
  message.is_bigendian = false;
  return message;
}

cv::Mat fromYuy2(const sensor_msgs::Image& message) {
  // The const_cast is safe: the image is only read.
  const cv::Mat image(static_cast<int>(message.height), static_cast<int>(message.width), CV_8UC2,
                      const_cast<std::uint8_t*>(message.data.data()), message.step);
  cv::Mat converted;
  cv::cvtColor(image, converted, cv::COLOR_YUV2BGR_YUY2);
  return converted;
}

cv::Mat convert(const sensor_msgs::Image& message, const PixelLayout& layout) {
  if (message.encoding == kYuy2) return fromYuy2(message);
  const bool as_is = isGrey(message.encoding) || message.encoding == encodings::TYPE_8UC3;
  const std::string wanted = as_is ? "" : layout.bytes == 2 ? encodings::BGR16 : encodings::BGR8;
  if (message.data.size() != std::uint64_t{message.step} * message.height) {
    return convert(packed(message, rowBytes(message, layout)), layout).clone();
  }
  if (layout.bytes == 2 && message.is_bigendian) {
    return cv_bridge::toCvCopy(littleEndian(message), wanted)->image;
  }
  return cv_bridge::toCvShare(message, nullptr, wanted)->image;
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
  const PixelLayout layout = layoutOf(message.encoding);
  checkImageSize(message.width, message.height);
  checkData(message, layout);
  cv::Mat image;
  try {
    image = convert(message, layout);
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
    message.places[i].margin = recognition.decision_values[static_cast<Eigen::Index>(i)];
  }
  message.seconds = seconds;
  for (const std::size_t cue : recognition.held) {
    message.held_cues.push_back(model.options.cues[cue].name);
  }
  return message;
}

void revise(const FilteredAnswer& answer, PlaceRecognition& message) {
  const RoomAnswer revised = roomAnswer(answer);
  for (std::size_t i = 0; i < message.places.size(); ++i) {
    message.places[i].probability = revised.probabilities[static_cast<Eigen::Index>(i)];
  }
  message.place = message.places[static_cast<std::size_t>(revised.place)].name;
  message.known = revised.known;
  message.confidence = revised.confidence;
  message.evidence = revised.evidence;
  message.reason.clear();
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
  sensor_msgs::Image message;
  cv_bridge::CvImage(header, image.channels() == 3 ? encodings::BGR8 : encodings::MONO8, image)
      .toImageMsg(message);
  return message;
}

}  // namespace place_recognition
