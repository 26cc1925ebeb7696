#include "ros/labelled_recording.h"

#include <std_msgs/String.h>

#include <filesystem>

#include "place_recognition/error.h"
#include "ros/labels.h"
#include "ros/node_names.h"

namespace place_recognition {
namespace {

constexpr const char* kActive = ".active";  // as rosbag record calls it
constexpr double kReportPeriod = 5;         // s

std::unique_ptr<StagedBag> openBag(const std::string& path) {
  if (path.empty()) return nullptr;
  if (std::filesystem::exists(path)) {
    throw Error("There is a file " + path + " already; give ~bag another name.");
  }
  if (std::filesystem::exists(path + kActive)) {
    throw Error(path + kActive +
                " is being recorded, or was left by a recorder that was killed; remove it, or "
                "rescue it with: rosbag reindex " +
                path + kActive);
  }
  return std::make_unique<StagedBag>(path, kActive);
}

std_msgs::String labelMessage(const std::string& place) {
  std_msgs::String label;
  label.data = place;
  return label;
}

const char* topicSuffix(const sensor_msgs::Image&) { return ""; }
const char* topicSuffix(const sensor_msgs::CompressedImage&) { return names::kCompressedSuffix; }

}  // namespace

LabelledRecording::LabelledRecording(const ros::NodeHandle& node,
                                     const ros::NodeHandle& private_node)
    : image_topic_(node.resolveName(names::kImage)),
      label_topic_(node.resolveName(names::kPlaceLabel)),
      bag_(openBag(private_node.param<std::string>("bag", ""))) {
  publisher_ = ros::NodeHandle(node).advertise<std_msgs::String>(names::kPlaceLabel,
                                                                 names::kAnswerQueue, true);
  publisher_.publish(labelMessage(place_));
  if (!bag_) return;
  ROS_INFO("Recording %s and %s to %s.", image_topic_.c_str(), label_topic_.c_str(),
           bag_->path().c_str());
  timer_ = ros::NodeHandle(node).createWallTimer(
      ros::WallDuration(kReportPeriod), [this](const ros::WallTimerEvent&) { reportProgress(); });
}

LabelledRecording::~LabelledRecording() {
  timer_.stop();
  if (!bag_) return;
  try {
    if (images_ == 0) {
      bag_->discard();
      ROS_WARN("No image has come on %s; nothing was recorded.", image_topic_.c_str());
    } else {
      bag_->complete();
      ROS_INFO("%s: %lu images.", bag_->path().c_str(), static_cast<unsigned long>(images_));
    }
  } catch (const Error& e) {
    ROS_ERROR("%s", e.what());
  }
}

void LabelledRecording::say(const std::string& place, const ros::Time& time) {
  if (!place.empty()) checkNewLabel(place, "The place");
  const std::lock_guard<std::mutex> lock(mutex_);
  if (place == place_) return;
  place_ = place;
  publisher_.publish(labelMessage(place));
  recordLabel(time);
}

void LabelledRecording::add(const ImageMessage& image, const ros::Time& time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (time < ros::TIME_MIN) return;  // a simulated clock that has not come yet
  recordLabel(time);
  image.visit([&](const auto& message) {
    record(image_topic_ + topicSuffix(message), time, message);
    ++images_;
  });
}

void LabelledRecording::recordLabel(const ros::Time& time) {
  if (place_ == recorded_place_ || time < ros::TIME_MIN) return;
  record(label_topic_, time, labelMessage(place_));
  recorded_place_ = place_;
}

/// A disk that refuses ends the node: somebody drives the robot for this recording.
template <typename Message>
void LabelledRecording::record(const std::string& topic, const ros::Time& time,
                               const Message& message) {
  if (!bag_ || failed_) return;
  try {
    bag_->write(topic, time, message);
  } catch (const Error& e) {
    failed_ = true;
    ROS_FATAL("The recording ends: %s", e.what());
    ros::requestShutdown();
  }
}

void LabelledRecording::reportProgress() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (images_ == reported_images_) {
    ROS_WARN("No image has come on %s for %.0f s.", image_topic_.c_str(), kReportPeriod);
  } else {
    ROS_INFO("%lu images; now %s.", static_cast<unsigned long>(images_),
             place_.empty() ? "without a label" : ("'" + place_ + "'").c_str());
  }
  reported_images_ = images_;
}

}  // namespace place_recognition
