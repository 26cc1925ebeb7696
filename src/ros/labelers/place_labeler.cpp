#include "ros/labelers/place_labeler.h"

#include <unistd.h>

#include "base/place_name.h"
#include "place_recognition/error.h"
#include "ros/nodes/node_main.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

constexpr char kEndKey = 'q';

LabelKeys labelKeys(Parameters& parameters) {
  return LabelKeys(parameters.texts("places"), parameters.integers("buttons"),
                   parameters.integer("no_place_button", -1, -1));
}

}  // namespace

PlaceLabeler::PlaceLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : PlaceLabeler(node, private_node, Parameters(private_node)) {}

PlaceLabeler::PlaceLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           Parameters parameters)
    : keys_(labelKeys(parameters)),
      recording_(node, parameters),
      input_(
          node, private_node, parameters,
          [this](const ImageMessage& image) { recording_.add(image); }, names::kRecordingQueue) {
  parameters.warnOfDoubts();
  for (const std::string& warning : warnOfLikeNames(keys_.places())) {
    ROS_WARN("%s", warning.c_str());
  }
  ros::NodeHandle public_handle(node);
  ros::NodeHandle private_handle(private_node);
  say_subscriber_ =
      private_handle.subscribe(names::kSay, names::kAnswerQueue, &PlaceLabeler::onSay, this);
  joy_subscriber_ =
      public_handle.subscribe(names::kJoy, names::kAnswerQueue, &PlaceLabeler::onJoy, this);
  say_server_ = private_handle.advertiseService(names::kSay, &PlaceLabeler::onSayService, this);
  if (recording_.isRecording()) {
    input_.subscribe();
    recording_.expectImages();
  }
  if (Keyboard::isUsable(STDIN_FILENO)) {
    keyboard_ = std::make_unique<Keyboard>(STDIN_FILENO, [this](char key) { onKey(key); });
    ROS_INFO("Press: %s, %c end.", keys_.help().c_str(), kEndKey);
  } else {
    ROS_INFO("There is no terminal for keys; state the room by a button or on %s. Rooms: %s.",
             say_server_.getService().c_str(), keys_.help().c_str());
  }
}

void PlaceLabeler::onKey(char key) {
  if (key == kEndKey) {
    requestEnd();
  } else if (const std::optional<std::string> place = keys_.placeOfKey(key)) {
    say(*place);
  } else {
    ROS_INFO("Press: %s, %c end.", keys_.help().c_str(), kEndKey);
  }
}

void PlaceLabeler::onSay(const std_msgs::StringConstPtr& message) {
  try {
    say(message->data);
  } catch (const Error& e) {
    ROS_WARN("%s", e.what());
  }
}

void PlaceLabeler::onJoy(const sensor_msgs::JoyConstPtr& message) {
  if (const auto place = keys_.placeOfButtons(message->buttons)) say(*place);
}

bool PlaceLabeler::onSayService(SayPlace::Request& request, SayPlace::Response& response) {
  try {
    const std::string place = say(request.place);
    response.success = true;
    response.message = place.empty() ? "No place." : "In '" + place + "'.";
  } catch (const Error& e) {
    response.message = e.what();
  }
  return true;
}

std::string PlaceLabeler::say(const std::string& name) {
  const std::string place = recording_.say(name);
  ROS_INFO("%s", place.empty() ? "No place." : ("In '" + place + "'.").c_str());
  return place;
}

}  // namespace place_recognition
