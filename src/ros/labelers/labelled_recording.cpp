#include "ros/labelers/labelled_recording.h"

#include <std_msgs/String.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "base/bag_name.h"
#include "base/place_name.h"
#include "base/user_path.h"
#include "labels/labels.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "ros/nodes/image_topics.h"
#include "ros/nodes/node_main.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

constexpr const char* kActive = StagedBag::kActive;
constexpr double kReportPeriod = 5;    // s
constexpr std::int64_t kTick = 1'000;  // ns, between entries at the same time of the clock
constexpr std::int64_t kLoggedStepBack = 500'000'000;  // ns; larger steps back are logged

std::unique_ptr<StagedBag> openBag(std::string path) {
  if (path.empty()) return nullptr;
  if (std::filesystem::is_directory(path) || path.back() == '/') {
    throw Error(path + " is a folder; set ~bag to a file in it, such as monday.bag.");
  }
  if (std::filesystem::path(path).extension() != ".bag") path += ".bag";  // like rosbag record
  path = behindLinks(path);
  if (std::filesystem::exists(path)) {
    throw Error("The file " + path + " already exists; set ~bag to another name.");
  }
  if (std::filesystem::exists(path + kActive)) {
    throw Error(path + kActive + ": " + whyActive(path + kActive) +
                "; in either case set ~bag to another name.");
  }
  requireNoLabelsBeside(path);
  return std::make_unique<StagedBag>(path, kActive);
}

std_msgs::String labelMessage(const std::string& place) {
  std_msgs::String label;
  label.data = place;
  return label;
}

std::string noClock(std::uint64_t images) {
  return std::to_string(images) +
         " images have arrived but cannot be recorded: /use_sim_time is true and there is no "
         "/clock.";
}

}  // namespace

LabelledRecording::LabelledRecording(const ros::NodeHandle& node, Parameters& parameters)
    : image_topic_(node.resolveName(names::kImage)),
      image_transport_(parameters.text("image_transport", "raw")),
      label_topic_(node.resolveName(names::kPlaceLabel)),
      bag_(openBag(userPath(parameters.text("bag")))),
      node_(node) {
  publisher_ = node_.advertise<std_msgs::String>(names::kPlaceLabel, names::kAnswerQueue, true);
  publisher_.publish(labelMessage(place_));
  if (!bag_) return;
  ROS_INFO("Recording %s and %s to %s.", image_topic_.c_str(), label_topic_.c_str(),
           bag_->path().c_str());
}

void LabelledRecording::expectImages() {
  timer_ = node_.createWallTimer(ros::WallDuration(kReportPeriod),
                                 [this](const ros::WallTimerEvent&) { reportProgress(); });
}

LabelledRecording::~LabelledRecording() {
  try {
    finish();
  } catch (const Error& e) {
    ROS_ERROR("%s", e.what());
  }
}

void LabelledRecording::finish() {
  timer_.stop();
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::unique_ptr<StagedBag> bag = std::move(bag_);
  if (!bag) return;
  if (images_ == 0) {
    bag->discard();
    throw Error(
        (timeless_ > 0 ? noClock(timeless_) : "No image has arrived on " + image_topic_ + ".") +
        " Nothing was recorded.");
  }
  const std::string rescue =
      " The recorded part is in " + bag->path() + kActive +
      "; when there is room on the disk, run: " + howToRepair(bag->path() + kActive);
  if (failed_) throw Error("The recording is incomplete." + rescue);
  try {
    bag->complete();
  } catch (const Error& e) {
    throw Error(e.what() + rescue);
  }
  ROS_INFO("%s: %lu images.", bag->path().c_str(), static_cast<unsigned long>(images_));
}

ros::Time LabelledRecording::nextTime() {
  const ros::Time now = ros::Time::now();
  if (now < ros::TIME_MIN) return {};  // a simulated clock that has not started
  const std::int64_t time = static_cast<std::int64_t>(now.toNSec()) + ahead_;
  const std::int64_t back = static_cast<std::int64_t>(last_time_.toNSec()) - time;
  if (back > kLoggedStepBack) {
    ROS_WARN("Time has jumped back by %.1f s; the recording continues as if it had not.",
             1e-9 * static_cast<double>(back));
  }
  if (back >= 0) ahead_ += back + kTick;
  last_time_.fromNSec(now.toNSec() + static_cast<std::uint64_t>(ahead_));
  return last_time_;
}

std::string LabelledRecording::say(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return change(name, nextTime());
}

std::string LabelledRecording::say(const std::string& name, const ros::Time& time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return change(name, time);
}

std::string LabelledRecording::change(const std::string& name, const ros::Time& time) {
  if (!name.empty()) checkLabel(name, "The place");
  const std::string place = placeName(name);
  if (place == place_) return place;
  place_ = place;
  publisher_.publish(labelMessage(place));
  recordLabel(time);
  return place;
}

ros::Time LabelledRecording::add(const ImageMessage& image) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time time = nextTime();
  if (time.isZero()) {
    ++timeless_;
    return time;
  }
  recordLabel(time);
  warnIfUnusable(image);
  image.visit([&](const auto& message) {
    record(image_topic_ + image.topicSuffix(), time, message);
    ++images_;
  });
  return time;
}

/// Tries one image in a while, because decoding all would take a core.
void LabelledRecording::warnIfUnusable(const ImageMessage& image) {
  const ros::WallTime now = ros::WallTime::now();
  if (now < next_trial_) return;
  next_trial_ = now + ros::WallDuration(kReportPeriod);
  try {
    image.image();
  } catch (const std::exception& e) {
    ROS_WARN("Images on %s are recorded but cannot be learned: %s", image_topic_.c_str(), e.what());
  }
}

void LabelledRecording::recordLabel(const ros::Time& time) {
  if (place_ == recorded_place_ || time.isZero()) return;
  record(label_topic_, time, labelMessage(place_));
  recorded_place_ = place_;
}

/// A failure to write ends the node, because somebody is driving the robot for this recording.
template <typename Message>
void LabelledRecording::record(const std::string& topic, const ros::Time& time,
                               const Message& message) {
  if (!bag_ || failed_) return;
  try {
    bag_->write(topic, time, message);
  } catch (const Error& e) {
    failed_ = true;
    ROS_FATAL("The recording ends: %s", e.what());
    requestEnd();
  }
}

void LabelledRecording::reportProgress() {
  std::unique_lock<std::mutex> lock(mutex_);
  if (images_ > reported_images_) {
    ROS_INFO("%lu images; now %s.", static_cast<unsigned long>(images_),
             place_.empty() ? "without a label" : ("'" + place_ + "'").c_str());
    reported_images_ = images_;
    const ros::Time now = ros::Time::now();
    if (now == reported_time_) {
      ROS_WARN(
          "/clock stands still: images and labels are recorded in order, but without their "
          "times.");
    }
    reported_time_ = now;
  } else if (images_ == 0 && timeless_ > 0) {
    ROS_WARN("%s", noClock(timeless_).c_str());
  } else {
    lock.unlock();  // asking the master takes time
    ROS_WARN("No image has arrived on %s for %.0f s. %s", image_topic_.c_str(), kReportPeriod,
             explainSilence(image_topic_, image_transport_).c_str());
  }
}

}  // namespace place_recognition
