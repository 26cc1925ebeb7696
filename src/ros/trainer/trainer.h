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

/// Learns models from labelled bags: the action ~train and the service ~retrain. One training at a
/// time; whoever asks for another meanwhile is refused. Callbacks may come from any number of
/// threads, of which ~retrain holds one as long as it lasts.
class Trainer {
 public:
  /// Throws Error if a parameter is wrong.
  Trainer(const ros::NodeHandle& node, const ros::NodeHandle& private_node);
  ~Trainer();
  Trainer(const Trainer&) = delete;
  Trainer& operator=(const Trainer&) = delete;

  /// Cancels the training at work, and refuses all that are asked for from now on.
  void finish();

 private:
  using ActionServer = actionlib::ActionServer<TrainAction>;
  using GoalHandle = ActionServer::GoalHandle;

  void onGoal(GoalHandle handle);
  void onCancel(GoalHandle handle);
  bool onRetrain(Retrain::Request& request, Retrain::Response& response);

  /// The job for `goal`, now the only one; null if there is one already.
  std::shared_ptr<TrainJob> begin(const TrainGoal& goal);
  void end();
  void work(GoalHandle handle, const std::shared_ptr<TrainJob>& job);
  void reloadRecognizers(const TrainGoal& goal, TrainResult& result);
  /// Empty: it has loaded the model; else why not.
  std::string reload(const std::string& recognizer, const std::string& model);

  ros::NodeHandle node_;
  std::vector<std::string> bag_roots_;

  std::mutex mutex_;  // of the four below
  bool finished_ = false;
  std::shared_ptr<TrainJob> job_;
  GoalHandle goal_;  // that of job_, if an action has asked for it
  std::thread worker_;

  ActionServer action_server_;
  ros::ServiceServer retrain_server_;
};

}  // namespace place_recognition
