#include "ros/nodes/image_topics.h"

#include <ros/this_node.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/text.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

constexpr const char* kImage = "sensor_msgs/Image";
constexpr const char* kCompressedImage = "sensor_msgs/CompressedImage";
constexpr const char* kPlaceRecognition = "place_recognition/PlaceRecognition";
const std::string kCompressed = "/compressed";

/// Types of topics by name.
using Topics = std::map<std::string, std::string>;

bool isDepth(const std::string& topic) { return endsWith(topic, "/compressedDepth"); }

bool isImages(const std::string& topic, const std::string& type) {
  return (type == kImage || type == kCompressedImage) && !isDepth(topic);
}

/// Whether the transport subscribes to topics of this type; plugins have their own types.
bool fits(const std::string& transport, const std::string& type) {
  if (transport == "raw") return type == kImage;
  return transport != "compressed" || type == kCompressedImage;
}

/// How to receive the images on `topic`.
std::string otherForm(const std::string& topic, const std::string& type) {
  const std::string is = topic + " is published as " + type + "; ";
  if (type == kImage) return is + "set ~image_transport to raw and remap image to " + topic + ".";
  if (!endsWith(topic, kCompressed)) {
    return is + "such a topic must end in /compressed: relay it to " + topic + kCompressed + ".";
  }
  return is + "set ~image_transport to compressed and remap image to " +
         topic.substr(0, topic.size() - kCompressed.size()) + ".";
}

/// The names of all recognizers, whose debug images do not come from a camera.
std::vector<std::string> recognizersOf(const ros::master::V_TopicInfo& published) {
  const std::string ending = std::string("/") + names::kRecognition;
  std::vector<std::string> recognizers;
  for (const ros::master::TopicInfo& info : published) {
    if (info.datatype != kPlaceRecognition || !endsWith(info.name, ending)) continue;
    recognizers.push_back(info.name.substr(0, info.name.size() - ending.size()));
  }
  return recognizers;
}

std::string listOfImageTopics(const Topics& topics) {
  std::string list;
  for (const auto& [name, type] : topics) {
    if (isImages(name, type)) list += (list.empty() ? "" : ", ") + name;
  }
  return list.empty() ? "Nobody publishes images." : "Images are published on: " + list + ".";
}

}  // namespace

std::string explainSilence(const std::string& topic, const std::string& transport,
                           const ros::master::V_TopicInfo& published, const std::string& node) {
  std::vector<std::string> own = recognizersOf(published);
  own.push_back(node);
  Topics topics;
  for (const ros::master::TopicInfo& info : published) {
    const bool is_own = std::any_of(own.begin(), own.end(), [&info](const std::string& recognizer) {
      return startsWith(info.name, recognizer + "/");
    });
    if (!is_own) topics[info.name] = info.datatype;
  }
  const std::string heard = transport == "raw" ? topic : topic + "/" + transport;
  const auto found = topics.find(heard);
  if (found != topics.end()) {
    const std::string& type = found->second;
    if (fits(transport, type)) {
      return heard +
             " is published, but no image arrives; check whether the camera sends: rostopic hz " +
             heard + ".";
    }
    if (isImages(heard, type)) return otherForm(heard, type);
    return heard + (isDepth(heard) ? " contains distances, not images."
                                   : " is published as " + type + ", which is not an image.");
  }
  for (const std::string& name : {topic, topic + kCompressed}) {
    const auto form = topics.find(name);
    if (form != topics.end() && isImages(name, form->second)) return otherForm(name, form->second);
  }
  return "Nobody publishes " + heard + ". " + listOfImageTopics(topics);
}

std::string explainSilence(const std::string& topic, const std::string& transport) {
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = "";
  ros::master::V_TopicInfo published;
  if (!ros::master::execute("getPublishedTopics", request, response, payload, false)) {
    return "The master does not answer.";
  }
  for (int i = 0; i < payload.size(); ++i) {
    published.emplace_back(payload[i][0], payload[i][1]);
  }
  return explainSilence(topic, transport, published, ros::this_node::getName());
}

}  // namespace place_recognition
