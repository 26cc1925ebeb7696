#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "ros/image_input.h"
#include "ros/staged_bag.h"

namespace place_recognition {

/// Says the place on `place_label` (latched, whenever it changes) and, if the parameter `~bag`
/// names a file, records it there together with the images, as openBagRun() reads it. Until the end
/// the file has `.active` after its name. Thread-safe.
class LabelledRecording {
 public:
  /// Throws Error if the file exists already, complete or not, or cannot be written.
  LabelledRecording(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// Completes the file.
  ~LabelledRecording();
  LabelledRecording(const LabelledRecording&) = delete;
  LabelledRecording& operator=(const LabelledRecording&) = delete;

  /// Whether images are wanted.
  bool isRecording() const { return bag_ != nullptr; }

  /// From `time` on the robot is in `place`; empty: in none. Throws Error if it is no place name.
  void say(const std::string& place, const ros::Time& time);

  /// An image that came at `time`.
  void add(const ImageMessage& image, const ros::Time& time);

 private:
  void recordLabel(const ros::Time& time);
  template <typename Message>
  void record(const std::string& topic, const ros::Time& time, const Message& message);
  void reportProgress();

  std::string image_topic_;
  std::string label_topic_;
  std::unique_ptr<StagedBag> bag_;  // none: nothing is recorded

  std::mutex mutex_;  // of all up to failed_
  std::string place_;
  std::string recorded_place_;
  std::uint64_t images_ = 0;
  std::uint64_t reported_images_ = 0;
  bool failed_ = false;

  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
