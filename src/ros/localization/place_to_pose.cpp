#include "ros/localization/place_to_pose.h"

#include <cmath>
#include <utility>

#include "base/contains.h"
#include "base/place_name.h"
#include "base/text.h"
#include "base/user_path.h"
#include "place_recognition/error.h"
#include "ros/messages/pose_conversions.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

/// Interval at which markers and warnings are updated, s of wall time.
constexpr double kPeriod = 0.2;

std::string fileOf(Parameters& parameters) {
  const std::string path = userPath(parameters.text("rooms"));
  if (path.empty()) throw Error("The parameter ~rooms is not set; name a file of room polygons.");
  return path;
}

HeldRoom::Options heldOptions(Parameters& parameters) {
  HeldRoom::Options options;
  options.min_probability = parameters.real("min_probability", 0.99, 0, 1);
  options.hold = parameters.real("hold", 1, 0);
  options.timeout = parameters.real("belief_timeout", 2, 0);
  return options;
}

/// The names missing in `other`, each once, in quotes and separated by commas.
std::string missingIn(const std::vector<std::string>& other,
                      const std::vector<std::string>& names) {
  std::vector<std::string> missing;
  std::string text;
  for (const std::string& name : names) {
    if (contains(other, name) || contains(missing, name)) continue;
    missing.push_back(name);
    text += (text.empty() ? "'" : ", '") + name + "'";
  }
  return text;
}

}  // namespace

PlaceToPose::PlaceToPose(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : PlaceToPose(node, private_node, Parameters(private_node)) {}

PlaceToPose::PlaceToPose(ros::NodeHandle node, ros::NodeHandle private_node, Parameters parameters)
    : file_(fileOf(parameters)),
      rooms_(readRoomPolygons(file_)),
      map_frame_(parameters.text("map_frame", "map")),
      markers_(rooms_, map_frame_),
      held_(heldOptions(parameters)),
      relocalizer_(node, parameters, map_frame_) {
  parameters.warnOfDoubts();
  for (const std::string& warning : warnOfLikeNames(rooms_.names())) {
    ROS_WARN("%s: %s", file_.c_str(), warning.c_str());
  }
  markers_publisher_ =
      private_node.advertise<visualization_msgs::MarkerArray>(names::kRoomMarkers, 1, true);
  room_pose_server_ =
      private_node.advertiseService(names::kRoomPose, &PlaceToPose::onRoomPose, this);
  belief_subscriber_ =
      node.subscribe(names::kRecognizerBelief, names::kAnswerQueue, &PlaceToPose::onBelief, this);
  timer_ = node.createWallTimer(ros::WallDuration(kPeriod),
                                [this](const ros::WallTimerEvent&) { onTimer(); });
  ROS_INFO("%s: the rooms %s.", file_.c_str(), roomsText().c_str());
}

std::string PlaceToPose::roomsText() const { return missingIn({}, rooms_.names()); }

ros::Time PlaceToPose::followClock() {
  const ros::Time now = ros::Time::now();
  if (now < last_time_) {
    held_.forget();
    relocalizer_.forget();
  }
  last_time_ = now;
  return now;
}

void PlaceToPose::onBelief(const PlaceRecognitionConstPtr& belief) {
  const ros::Time now = followClock();
  if (now.isZero()) return;  // there is no clock yet
  compareRooms(*belief);
  held_.add(*belief, now);
  const std::string room = held_.sureRoom(now);
  const auto area = rooms_.anywhereIn(room);
  if (area) relocalizer_.robotIsIn(room, *area, now);
}

void PlaceToPose::compareRooms(const PlaceRecognition& belief) {
  if (model_version_ == belief.model_version) return;
  model_version_ = belief.model_version;
  std::vector<std::string> known;
  for (const PlaceScore& place : belief.places) known.push_back(place.name);
  const std::string without_polygon = missingIn(rooms_.names(), known);
  if (!without_polygon.empty()) {
    ROS_WARN(
        "The model '%s' knows %s, for which %s has no polygon, so there is no pose for them. Its "
        "rooms are %s.",
        belief.model_name.c_str(), without_polygon.c_str(), file_.c_str(), roomsText().c_str());
  }
  const std::string not_known = missingIn(known, rooms_.names());
  if (!not_known.empty()) {
    ROS_INFO("The model '%s' does not know %s of %s.", belief.model_name.c_str(), not_known.c_str(),
             file_.c_str());
  }
}

bool PlaceToPose::onRoomPose(RoomPose::Request& request, RoomPose::Response& response) {
  const ros::Time now = followClock();
  response.place = request.place.empty() ? held_.sureRoom(now) : placeName(request.place);
  if (response.place.empty()) {
    response.message = "The room is not certain: " + held_.whyNot(now) + ".";
    return true;
  }
  const auto area = rooms_.anywhereIn(response.place);
  if (!area) {
    response.message =
        file_ + " has no room '" + response.place + "'; its rooms are " + roomsText() + ".";
    return true;
  }
  response.success = true;
  response.pose.header.frame_id = map_frame_;
  response.pose.header.stamp = now;
  response.pose.pose = toPose(*area);
  return true;
}

void PlaceToPose::onTimer() {
  const ros::Time now = followClock();
  relocalizer_.watch(now);
  publishMarkers(now);
}

void PlaceToPose::publishMarkers(const ros::Time& now) {
  if (markers_publisher_.getNumSubscribers() == 0) return;
  const auto probabilityOf = [&](const std::string& room) {
    return held_.probabilityOf(room, now);
  };
  std::vector<long> percents;
  for (const std::string& room : rooms_.names()) {
    percents.push_back(std::lround(100 * probabilityOf(room)));
  }
  if (percents == shown_) return;
  visualization_msgs::MarkerArray array = markers_.at(probabilityOf);
  if (shown_.empty()) {  // rviz may still show those of an earlier node, from another file
    visualization_msgs::Marker all;
    all.header.frame_id = map_frame_;
    all.action = visualization_msgs::Marker::DELETEALL;
    array.markers.insert(array.markers.begin(), all);
  }
  shown_ = std::move(percents);
  markers_publisher_.publish(array);
}

}  // namespace place_recognition
