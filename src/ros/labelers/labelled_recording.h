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

/// Says the place on `place_label` (latched, whenever it changes) and, if the parameter `~bag`
/// names a file, records it there together with the images, as openBagRecording() reads it. Until
/// the end the file has `.active` after its name. Thread-safe.
class LabelledRecording {
 public:
  /// Throws Error if the file exists already, complete or not, or cannot be written.
  LabelledRecording(const ros::NodeHandle& node, Parameters& parameters);

  /// As finish(), but what is wrong is only logged.
  ~LabelledRecording();
  LabelledRecording(const LabelledRecording&) = delete;
  LabelledRecording& operator=(const LabelledRecording&) = delete;

  /// Whether images are wanted.
  bool isRecording() const { return bag_ != nullptr; }

  /// From now on images should come: logs now and then how many have, or why none may come.
  void expectImages();

  /// From now on, or from the image on that add() returned `time` for, the robot is in this place;
  /// empty: in none. Returns the name as it is recorded. Throws Error if it is no place name.
  std::string say(const std::string& name);
  std::string say(const std::string& name, const ros::Time& time);

  /// An image that has come just now. Returns its time in the bag; zero: there is no clock yet, and
  /// it is not recorded.
  ros::Time add(const ImageMessage& image);

  /// Completes the file, once. Throws Error if it cannot be completed, if the disk has refused
  /// something meanwhile, or if no image has come; then there is no file.
  void finish();

 private:
  /// The time in the bag of what comes now: after all before, whatever the clock does, so that each
  /// image keeps its label.
  ros::Time nextTime();
  std::string change(const std::string& name, const ros::Time& time);
  void recordLabel(const ros::Time& time);
  template <typename Message>
  void record(const std::string& topic, const ros::Time& time, const Message& message);
  void reportProgress();

  std::string image_topic_;
  std::string image_transport_;
  std::string label_topic_;
  std::unique_ptr<StagedBag> bag_;  // none: nothing is recorded

  std::mutex mutex_;  // of all up to ahead_
  std::string place_;
  std::string recorded_place_;
  std::uint64_t images_ = 0;
  std::uint64_t timeless_ = 0;  // images that came before simulated time did
  std::uint64_t reported_images_ = 0;
  bool failed_ = false;
  ros::Time last_time_;     // in the bag
  ros::Duration ahead_{0};  // how far the bag is ahead of a clock that has jumped back

  ros::Time reported_time_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
