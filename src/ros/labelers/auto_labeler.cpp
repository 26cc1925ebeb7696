#include "ros/labelers/auto_labeler.h"

#include <algorithm>
#include <vector>

#include "base/place_name.h"
#include "base/text.h"
#include "base/user_path.h"
#include "place_recognition/error.h"
#include "ros/messages/pose_conversions.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

/// Maximum time that the pose of an image may take to arrive, s.
constexpr double kMaxPatience = 3600;
/// Interval at which poses are looked up for waiting images, s.
constexpr double kPosePoll = 0.02;

RoomPolygons roomsOf(Parameters& parameters) {
  const std::string path = userPath(parameters.text("rooms"));
  if (path.empty()) throw Error("The parameter ~rooms is not set; name a file of room polygons.");
  return readRoomPolygons(path);
}

}  // namespace

AutoLabeler::AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : AutoLabeler(node, private_node, Parameters(private_node)) {}

AutoLabeler::AutoLabeler(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                         Parameters parameters)
    : rooms_(roomsOf(parameters)),
      map_frame_(parameters.text("map_frame", "map")),
      robot_frame_(parameters.text("robot_frame", "base_link")),
      margin_(parameters.real("margin", 0.3, 0)),
      max_deviation_(parameters.real("max_deviation", 0.5, 0)),
      patience_(parameters.real("pose_timeout", 0.2, 0, kMaxPatience)),
      recording_(node, parameters),
      input_(
          node, private_node, parameters, [this](const ImageMessage& image) { onImage(image); },
          names::kRecordingQueue) {
  parameters.warnOfDoubts();
  for (const std::string& warning : warnOfLikeNames(rooms_.names())) {
    ROS_WARN("%s: %s", userPath(parameters.text("rooms")).c_str(), warning.c_str());
  }
  pose_subscriber_ = ros::NodeHandle(node).subscribe(names::kPose, 1, &AutoLabeler::onPose, this);
  timer_ = ros::NodeHandle(node).createWallTimer(
      ros::WallDuration(kPosePoll), [this](const ros::WallTimerEvent&) { labelWaiting(); });
  input_.subscribe();
  recording_.expectImages();
  ROS_INFO("%s; labelling by the pose of %s in %s.", counted(rooms_.size(), "room").c_str(),
           robot_frame_.c_str(), map_frame_.c_str());
}

void AutoLabeler::finish() {
  for (; !waiting_.empty(); waiting_.pop_front()) {
    label(waiting_.front(), positionAt(waiting_.front().stamp));
  }
  if (labelled_ == 0 && unlabelled_ > 0) {
    ROS_WARN("None of %lu images has a label. %s", static_cast<unsigned long>(unlabelled_),
             problem_.c_str());
  } else {
    ROS_INFO("%lu images have a label, %lu have none.", static_cast<unsigned long>(labelled_),
             static_cast<unsigned long>(unlabelled_));
  }
  recording_.finish();
}

void AutoLabeler::onImage(const ImageMessage& image) {
  const ros::Time time = recording_.add(image);
  if (time.isZero()) return;
  const ros::Time stamp = image.header().stamp;
  const bool is_stamped = !standing_stamp_.standsStill(stamp.toSec(), time.toSec());
  waiting_.push_back({is_stamped ? stamp : ros::Time(), ros::Time::now(), time});
  labelWaiting();
}

void AutoLabeler::onPose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose) {
  deviation_ = largestDeviation(positionCovariance(pose->pose));
}

void AutoLabeler::labelWaiting() {
  for (; !waiting_.empty(); waiting_.pop_front()) {
    const std::optional<Eigen::Vector2d> position = positionAt(waiting_.front().stamp);
    if (!position && mayStillCome(waiting_.front())) return;
    label(waiting_.front(), position);
  }
}

bool AutoLabeler::mayStillCome(const Waiting& image) const {
  const ros::Time now = ros::Time::now();
  // Time may have jumped back, for example in a looped bag.
  return !image.stamp.isZero() && now >= image.arrival && now < image.arrival + patience_;
}

void AutoLabeler::label(const Waiting& image, const std::optional<Eigen::Vector2d>& position) {
  if (!position) ROS_WARN_THROTTLE(10, "%s", problem_.c_str());
  const bool sure = position && deviation_ <= max_deviation_;  // false for NaN
  const std::string room = sure ? rooms_.at(*position, margin_) : "";
  ++(room.empty() ? unlabelled_ : labelled_);
  recording_.say(room, image.time);
}

std::optional<Eigen::Vector2d> AutoLabeler::positionAt(const ros::Time& stamp) {
  if (stamp.isZero()) {  // tf would interpret it as "the latest"
    problem_ =
        "The images have no stamps, or all the same, so they cannot be labelled by the pose.";
    return std::nullopt;
  }
  try {
    const geometry_msgs::Vector3 position =
        transforms_.lookupTransform(map_frame_, robot_frame_, stamp).transform.translation;
    return Eigen::Vector2d(position.x, position.y);
  } catch (const std::runtime_error& e) {  // of tf2, or of ros::Time for an impossible stamp
    const std::string missing = missingFrame();
    problem_ = "No label because there is no pose: " + (missing.empty() ? e.what() : missing);
    return std::nullopt;
  }
}

std::string AutoLabeler::missingFrame() const {
  std::vector<std::string> frames;
  transforms_._getFrameStrings(frames);
  std::sort(frames.begin(), frames.end());
  if (frames.empty()) return "nobody publishes tf.";
  for (const std::string& frame : {map_frame_, robot_frame_}) {
    if (transforms_._frameExists(frame)) continue;
    return "tf has no frame '" + frame + "', only " + listed(frames) +
           "; start its publisher, or set ~map_frame and ~robot_frame.";
  }
  return "";
}

}  // namespace place_recognition
