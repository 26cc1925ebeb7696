#pragma once

#include <actionlib/server/action_server.h>
#include <place_recognition/Retrain.h>
#include <place_recognition/TrainAction.h>
#include <ros/ros.h>

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ros/trainer/train_job.h"

namespace place_recognition {

/// Trains models from labelled bags: the action ~train and the service ~retrain. Only one training
/// runs at a time; other requests are rejected meanwhile. Callbacks may come from any number of
/// threads; ~retrain occupies one until it finishes.
class Trainer {
 public:
  /// Throws Error if a parameter is invalid.
  Trainer(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~Trainer();
  Trainer(const Trainer&) = delete;
  Trainer& operator=(const Trainer&) = delete;

  /// Cancels the running training, and rejects all later requests.
  void finish();

 private:
  using ActionServer = actionlib::ActionServer<TrainAction>;
  using GoalHandle = ActionServer::GoalHandle;

  void onGoal(GoalHandle handle);
  void onCancel(GoalHandle handle);
  bool onRetrain(Retrain::Request& request, Retrain::Response& response);

  /// Makes a job for `goal` the current one; null if there already is one.
  std::shared_ptr<TrainJob> begin(const TrainGoal& goal);
  void end();
  void work(GoalHandle handle, const std::shared_ptr<TrainJob>& job);
  void reloadRecognizers(const TrainGoal& goal, TrainResult& result);
  /// Empty if the recognizer has loaded the model; else the reason.
  std::string reload(const std::string& recognizer, const std::string& model);

  ros::NodeHandle node_;
  std::vector<std::string> bag_roots_;

  std::mutex mutex_;  // guards the four below
  bool finished_ = false;
  std::shared_ptr<TrainJob> job_;
  GoalHandle goal_;  // of job_, if an action requested it
  std::thread worker_;

  ActionServer action_server_;
  ros::ServiceServer retrain_server_;
};

}  // namespace place_recognition
