#pragma once

#include <ros/ros.h>

#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "ros/recognizer/camera_list.h"
#include "ros/recognizer/model_slot.h"

namespace place_recognition {

/// The models in use, one for all cameras or one per camera, and their topic `~model_info`.
/// Thread-safe, except for advertise().
class CameraModels {
 public:
  /// `common`: the model of cameras that have none of their own; may be empty.
  CameraModels(const ros::NodeHandle& private_node, const std::vector<CameraName>& cameras,
               const std::string& common);

  /// Advertises the topic. Call it once, before anything is loaded.
  void advertise();

  /// Loads the models that the parameters name; only logs those that cannot be loaded.
  void loadFirst();

  /// Uses the model `name` for all cameras. Throws Error like ModelSlot::read(); then every camera
  /// keeps its model.
  void load(const std::string& name);

  /// Reads the models in use again. Throws Error like load().
  void reload();

  /// The slot of a camera; cameras without a model of their own share the first one.
  const ModelSlot& slotOf(std::size_t camera) const;

  /// Names and sizes of the models in use, separated by commas; empty if there is none.
  std::string text() const;

 private:
  void publishInfo();

  ros::NodeHandle private_node_;
  std::vector<std::string> first_names_;  // one per slot
  std::deque<ModelSlot> slots_;
  std::mutex changing_;  // the models, one change at a time
  ros::Publisher info_publisher_;
};

}  // namespace place_recognition
