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
/// names a file, records it there together with the images, as openBagRun() reads it. Until the end
/// the file has `.active` after its name. Thread-safe.
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

  /// From `time` on, which may lie before images that have been added, the robot is in `place`;
  /// empty: in none. Throws Error if it is no place name.
  std::string say(const std::string& name, const ros::Time& time);

  /// An image that came at `time`.
  void add(const ImageMessage& image, const ros::Time& time);

  /// Completes the file, once. Throws Error if it cannot be completed, if the disk has refused
  /// something meanwhile, or if no image has come; then there is no file.
  void finish();

 private:
  void recordLabel(const ros::Time& time);
  template <typename Message>
  void record(const std::string& topic, const ros::Time& time, const Message& message);
  void reportProgress();

  std::string image_topic_;
  std::string image_transport_;
  std::string label_topic_;
  std::unique_ptr<StagedBag> bag_;  // none: nothing is recorded

  std::mutex mutex_;  // of all up to failed_
  std::string place_;
  std::string recorded_place_;
  std::uint64_t images_ = 0;
  std::uint64_t timeless_ = 0;  // images that came before simulated time did
  std::uint64_t reported_images_ = 0;
  bool failed_ = false;

  ros::Time reported_time_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
