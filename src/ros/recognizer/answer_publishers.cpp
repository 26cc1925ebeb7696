#include "ros/recognizer/answer_publishers.h"

#include <std_msgs/String.h>
#include <visualization_msgs/Marker.h>

#include "ros/nodes/node_names.h"
#include "ros/recognizer/place_marker.h"

namespace place_recognition {

void AnswerPublishers::advertise(ros::NodeHandle private_node,
                                 const std::function<void()>& changed) {
  const ros::SubscriberStatusCallback callback = [changed](const ros::SingleSubscriberPublisher&) {
    changed();
  };
  const auto advertised = [&](const char* name, auto message, bool latched = false) {
    return private_node.advertise<decltype(message)>(name, names::kAnswerQueue, callback, callback,
                                                     nullptr, latched);
  };
  recognition_ = advertised(names::kRecognition, PlaceRecognition());
  place_ = advertised(names::kPlace, std_msgs::String(), true);
  belief_ = advertised(names::kBelief, PlaceRecognition());
  smoothed_ = advertised(names::kSmoothed, PlaceRecognition());
  marker_ = advertised(names::kMarker, visualization_msgs::Marker());
}

bool AnswerPublishers::isWanted() const {
  for (const ros::Publisher& publisher : {recognition_, place_, belief_, smoothed_, marker_}) {
    if (publisher.getNumSubscribers() > 0) return true;
  }
  return false;
}

void AnswerPublishers::publishOverTime(const std::string& place, const PlaceRecognition& message,
                                       PlaceTracker& tracker) {
  publishPlace(place);
  if (belief_.getNumSubscribers() > 0) belief_.publish(tracker.belief(message));
  publishSmoothed(message, tracker);
  if (marker_.getNumSubscribers() > 0) marker_.publish(placeMarker(place, message.header));
}

void AnswerPublishers::publishPlace(const std::string& place) {
  if (place == last_place_) return;
  last_place_ = place;
  std_msgs::String message;
  message.data = place;
  place_.publish(message);
}

void AnswerPublishers::publishSmoothed(const PlaceRecognition& message, PlaceTracker& tracker) {
  if (smoothed_.getNumSubscribers() == 0) {
    tracker.dropSmoothed();
    return;
  }
  for (const PlaceRecognition& answer : tracker.smooth(message)) smoothed_.publish(answer);
}

void AnswerPublishers::forget(PlaceTracker& tracker) {
  for (const PlaceRecognition& answer : tracker.reset()) smoothed_.publish(answer);
  publishPlace(kUnknownPlace);
}

}  // namespace place_recognition
