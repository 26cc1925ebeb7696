#pragma once

#include <string>

#include "base/text.h"

namespace place_recognition {

// How image_transport publishes images: the types of the messages and the endings of the topics.

inline const std::string kImageType = "sensor_msgs/Image";
inline const std::string kCompressedImageType = "sensor_msgs/CompressedImage";
inline const std::string kCompressedSuffix = "/compressed";

/// Whether the images of a topic are distances, by its name; they cannot be used as a camera's.
inline bool isCompressedDepth(const std::string& topic) {
  return endsWith(topic, "/compressedDepth");
}

/// Whether the messages of a topic are images that can be used.
inline bool areImages(const std::string& topic, const std::string& type) {
  return (type == kImageType || type == kCompressedImageType) && !isCompressedDepth(topic);
}

/// The topic of a camera, given that of its images.
inline std::string withoutCompressed(const std::string& topic) {
  const bool ends = topic.size() > kCompressedSuffix.size() && endsWith(topic, kCompressedSuffix);
  return ends ? topic.substr(0, topic.size() - kCompressedSuffix.size()) : topic;
}

}  // namespace place_recognition
