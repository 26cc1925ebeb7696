#pragma once

#include <rosbag/bag.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ros/messages/image_types.h"

namespace place_recognition {

inline const std::string kLabelType = "std_msgs/String";

/// A topic of a bag.
struct RecordedTopic {
  std::string type;  ///< of its messages, such as "sensor_msgs/Image"
  std::uint32_t messages = 0;
};

/// By name.
using RecordedTopics = std::map<std::string, RecordedTopic>;

RecordedTopics listTopics(const rosbag::Bag& bag);

/// The topic of labels that `wanted` refers to, with or without leading slashes. Empty if the bag
/// has none and `wanted` is empty or the default name. Throws Error if the named topic is missing
/// or contains no labels.
std::string chooseLabelTopic(const RecordedTopics& topics, const std::string& wanted);

/// The image topics that `wanted` refers to, one per camera; "/compressed" and leading slashes
/// may be omitted. If `wanted` is empty, the topic of the only camera. Throws Error, listing the
/// existing topics, if one is missing, has no images or is named twice.
std::vector<std::string> chooseImageTopics(const RecordedTopics& topics,
                                           const std::vector<std::string>& wanted);

/// The topic of a camera, given that of its images, which may end in "/compressed"; with one
/// leading slash.
std::string cameraOf(const std::string& topic);

}  // namespace place_recognition
