#pragma once

#include <rosbag/bag.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace place_recognition {

inline const std::string kImageType = "sensor_msgs/Image";
inline const std::string kCompressedImageType = "sensor_msgs/CompressedImage";

/// A topic of a bag.
struct RecordedTopic {
  std::string type;  ///< of its messages, as "sensor_msgs/Image"
  std::uint32_t messages = 0;

  bool hasImages() const { return type == kImageType || type == kCompressedImageType; }
};

/// By name.
using RecordedTopics = std::map<std::string, RecordedTopic>;

RecordedTopics listTopics(const rosbag::Bag& bag);

/// The topic of labels that is meant by `wanted`, with or without slashes at its start. Empty if
/// the bag has none and `wanted` is empty or the default name. Throws Error if a topic was named
/// that is not there or holds no labels.
std::string chooseLabelTopic(const RecordedTopics& topics, const std::string& wanted);

/// The topics of images that are meant by `wanted`, one per camera, also by their names without
/// "/compressed" or slashes at their start; the only camera's if `wanted` is empty. Throws Error,
/// with the topics that there are, if one is not there, has no images or is named twice.
std::vector<std::string> chooseImageTopics(const RecordedTopics& topics,
                                           const std::vector<std::string>& wanted);

/// The topic of a camera by that of its images, which may end in "/compressed".
std::string cameraOf(const std::string& topic);

}  // namespace place_recognition
