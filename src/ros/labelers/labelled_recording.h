#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "ros/bags/staged_bag.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Publishes the place on `place_label` (latched, whenever it changes) and, if the parameter `~bag`
/// names a file, records it there together with the images, in the format of openBagRecording().
/// During recording the file name ends in `.active`. Thread-safe.
class LabelledRecording {
 public:
  /// Throws Error if the file already exists, complete or not, if a file beside it would replace
  /// its labels, or if it cannot be written.
  LabelledRecording(const ros::NodeHandle& node, Parameters& parameters);

  /// Calls finish(), but only logs errors.
  ~LabelledRecording();
  LabelledRecording(const LabelledRecording&) = delete;
  LabelledRecording& operator=(const LabelledRecording&) = delete;

  /// Whether images are recorded.
  bool isRecording() const { return bag_ != nullptr; }

  /// Begins to log regularly how many images have arrived, or why none may arrive.
  void expectImages();

  /// Sets the place of the robot, from now on or from the image for which add() returned `time`;
  /// empty means none. Returns the name as recorded. Throws Error if it is not a place name.
  std::string say(const std::string& name);
  std::string say(const std::string& name, const ros::Time& time);

  /// Adds an image that has just arrived. Returns its time in the bag; zero if there is no clock
  /// yet, in which case it is not recorded.
  ros::Time add(const ImageMessage& image);

  /// Completes the file, once. Throws Error if that fails, if writing has failed earlier, or if no
  /// image has arrived; then there is no file.
  void finish();

 private:
  /// The time in the bag for what arrives now. It is later than all earlier ones, whatever the
  /// clock does, so that each image keeps its label.
  ros::Time nextTime();
  std::string change(const std::string& name, const ros::Time& time);
  void recordLabel(const ros::Time& time);
  void warnIfUnusable(const ImageMessage& image);
  template <typename Message>
  void record(const std::string& topic, const ros::Time& time, const Message& message);
  void reportProgress();

  std::string image_topic_;
  std::string image_transport_;
  std::string label_topic_;
  std::unique_ptr<StagedBag> bag_;  // null: nothing is recorded

  std::mutex mutex_;  // guards everything up to ahead_
  std::string place_;
  std::string recorded_place_;
  std::uint64_t images_ = 0;
  std::uint64_t timeless_ = 0;  // images that arrived before simulated time started
  std::uint64_t reported_images_ = 0;
  bool failed_ = false;
  ros::WallTime next_trial_;  // of an image
  ros::Time last_time_;       // in the bag
  /// Lead of the bag over a clock that has jumped back, ns; a ros::Duration cannot represent each.
  std::int64_t ahead_ = 0;

  ros::Time reported_time_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
