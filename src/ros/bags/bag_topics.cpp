#include "ros/bags/bag_topics.h"

#include <rosbag/query.h>
#include <rosbag/view.h>

#include <algorithm>

#include "place_recognition/camera_correlation.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/bag_recording.h"

namespace place_recognition {
namespace {

/// Names and types, for a message.
std::string listed(const RecordedTopics& topics, bool images_only) {
  std::string text;
  for (const auto& [name, topic] : topics) {
    if (images_only && !areImages(name, topic.type)) continue;
    text += (text.empty() ? "" : ", ") + name + " (" + topic.type + ")";
  }
  return text.empty() ? "none" : text;
}

/// The topic that `wanted` refers to, possibly without "/compressed" or leading slashes; if it is
/// empty, the topic of the only camera.
std::string chooseImageTopic(const RecordedTopics& topics, const std::string& wanted) {
  std::vector<std::string> candidates;  // in order of name, so that compressed ones follow raw ones
  for (const auto& [name, topic] : topics) {
    if (!areImages(name, topic.type)) continue;
    if (name == wanted) return name;
    candidates.push_back(name);
  }
  if (candidates.empty()) {
    std::vector<std::string> names;
    for (const auto& [name, topic] : topics) names.push_back(name);
    throw Error(whyNoImages(names) + "; its topics are " + listed(topics, false));
  }
  if (!wanted.empty()) {
    for (const std::string& suffix : {std::string(), kCompressedSuffix}) {
      const auto meant = [&](const std::string& name) {
        return bareName(name) == bareName(wanted) + suffix;
      };
      const auto found = std::find_if(candidates.begin(), candidates.end(), meant);
      if (found != candidates.end()) return *found;
    }
    throw Error("it has no images on " + wanted + "; the image topics are " + listed(topics, true));
  }
  const std::string& first = candidates.front();
  const bool one_camera =
      std::all_of(candidates.begin(), candidates.end(), [&first](const std::string& name) {
        return name == first || name == first + kCompressedSuffix;
      });
  if (!one_camera) {
    throw Error(
        "it has several image topics; select one with --image-topic, or, for several cameras "
        "of one robot, several separated by commas: " +
        listed(topics, true));
  }
  return first;
}

}  // namespace

RecordedTopics listTopics(const rosbag::Bag& bag) {
  RecordedTopics topics;
  for (const rosbag::ConnectionInfo* connection : rosbag::View(bag).getConnections()) {
    topics[connection->topic].type = connection->datatype;
  }
  for (auto& [name, topic] : topics) {
    topic.messages = rosbag::View(bag, rosbag::TopicQuery(name)).size();
  }
  return topics;
}

std::string chooseLabelTopic(const RecordedTopics& topics, const std::string& wanted) {
  auto found = topics.find(wanted);
  for (auto topic = topics.begin(); found == topics.end() && topic != topics.end(); ++topic) {
    if (bareName(topic->first) == bareName(wanted)) found = topic;
  }
  if (found == topics.end()) {
    if (wanted.empty() || wanted == BagRecordingOptions().label_topic) return "";
    throw Error("it has no topic " + wanted + " for labels; its topics are " +
                listed(topics, false));
  }
  if (found->second.type != kLabelType) {
    throw Error("the label topic " + wanted + " has the type " + found->second.type + ", not " +
                kLabelType);
  }
  return found->first;
}

std::vector<std::string> chooseImageTopics(const RecordedTopics& topics,
                                           const std::vector<std::string>& wanted) {
  std::vector<std::string> chosen;
  if (wanted.size() > kMaxCameras) {
    throw Error("at most " + std::to_string(kMaxCameras) +
                " cameras of a robot are supported; name fewer image topics");
  }
  if (wanted.empty()) chosen.push_back(chooseImageTopic(topics, ""));
  for (const std::string& one : wanted) {
    const std::string topic = chooseImageTopic(topics, one);
    const bool again = std::any_of(chosen.begin(), chosen.end(), [&](const std::string& other) {
      return cameraOf(other) == cameraOf(topic);
    });
    if (again)
      throw Error("its camera " + cameraOf(topic) + " is named twice; name each only once");
    chosen.push_back(topic);
  }
  return chosen;
}

std::string cameraOf(const std::string& topic) { return "/" + bareName(withoutCompressed(topic)); }

}  // namespace place_recognition
