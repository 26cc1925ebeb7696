#include "ros/nodes/image_topics.h"

#include <ros/this_node.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/text.h"
#include "ros/messages/image_types.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

constexpr const char* kPlaceRecognition = "place_recognition/PlaceRecognition";

/// Types of topics by name.
using Topics = std::map<std::string, std::string>;

/// Whether the transport subscribes to topics of this type; plugins have their own types.
bool fits(const std::string& transport, const std::string& type) {
  if (transport == "raw") return type == kImageType;
  return transport != "compressed" || type == kCompressedImageType;
}

/// How to receive the images on `topic`.
std::string otherForm(const std::string& topic, const std::string& type) {
  const std::string is = topic + " is published as " + type + "; ";
  if (type == kImageType)
    return is + "set ~image_transport to raw and remap image to " + topic + ".";
  if (!endsWith(topic, kCompressedSuffix)) {
    return is + "such a topic must end in /compressed: relay it to " + topic + kCompressedSuffix +
           ".";
  }
  return is + "set ~image_transport to compressed and remap image to " + withoutCompressed(topic) +
         ".";
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
    if (areImages(name, type)) list += (list.empty() ? "" : ", ") + name;
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
    if (areImages(heard, type)) return otherForm(heard, type);
    return heard + (isCompressedDepth(heard)
                        ? " contains distances, not images."
                        : " is published as " + type + ", which is not an image.");
  }
  for (const std::string& name : {topic, topic + kCompressedSuffix}) {
    const auto form = topics.find(name);
    if (form != topics.end() && areImages(name, form->second)) return otherForm(name, form->second);
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
