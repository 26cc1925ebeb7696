#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <string>
#include <vector>

#include "ros/recognizer/image_status.h"
#include "ros/recognizer/model_slot.h"

namespace place_recognition {

/// Reports of place_recognizer on /diagnostics, once per second: the state of its models, and the
/// images and answers of each camera. Not thread-safe; reports in the threads of the node handle.
class Diagnostics {
 public:
  Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
              const std::string& node_name);

  /// Adds a source, reported as `name`, which must outlive this; only before start().
  void add(const std::string& name, const ModelSlot& model_slot);
  void add(const std::string& name, ImageStatus& images);

  /// Starts reporting.
  void start();

 private:
  ros::NodeHandle node_;
  std::vector<ImageStatus*> images_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace place_recognition
