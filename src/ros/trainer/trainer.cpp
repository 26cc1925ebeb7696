#include "ros/trainer/trainer.h"

#include <place_recognition/LoadModel.h>

#include <filesystem>

#include "base/confined_path.h"
#include "base/user_path.h"
#include "place_recognition/network.h"
#include "ros/nodes/message_fields.h"
#include "ros/nodes/node_names.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {
namespace {

/// Time that a recognizer may take to appear, s.
constexpr double kServiceTimeout = 2;

constexpr const char* kBusy = "Another training is running; wait for it or cancel it.";

std::vector<std::string> bagRoots(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  std::vector<std::string> roots = parameters.texts("bag_roots");
  parameters.warnOfDoubts();
  for (std::string& root : roots) {
    root = userPath(root);
    if (!std::filesystem::is_directory(root)) {
      ROS_WARN("The folder %s in ~bag_roots does not exist.", root.c_str());
    }
  }
  return roots.empty() ? defaultBagRoots() : roots;
}

/// Whether such a service exists or appears soon, by wall time, because simulated time may stand
/// still.
bool appears(const std::string& service) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kServiceTimeout);
  while (!ros::service::exists(service, false)) {
    if (ros::WallTime::now() > end) return false;
    ros::WallDuration(0.05).sleep();
  }
  return true;
}

void log(const TrainResult& result) {
  if (result.success) {
    ROS_INFO("%s", result.message.c_str());
  } else {
    ROS_ERROR("Training failed: %s", result.message.c_str());
  }
}

void logFeedback(const TrainFeedback& feedback) {
  ROS_INFO_THROTTLE(5, "%s", feedback.message.c_str());
}

void logWarning(const std::string& sentence) { ROS_WARN("%s", sentence.c_str()); }

}  // namespace

Trainer::Trainer(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : node_(node),
      bag_roots_(bagRoots(private_node)),
      action_server_(
          private_node, names::kTrain, [this](GoalHandle handle) { onGoal(handle); },
          [this](GoalHandle handle) { onCancel(handle); }, false) {
  limitOpenCvToOneThread();
  retrain_server_ =
      ros::NodeHandle(private_node).advertiseService(names::kRetrain, &Trainer::onRetrain, this);
  action_server_.start();
}

Trainer::~Trainer() {
  finish();
  if (worker_.joinable()) worker_.join();
}

void Trainer::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  finished_ = true;
  if (job_) job_->cancel();
}

std::shared_ptr<TrainJob> Trainer::begin(const TrainGoal& goal) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (job_ || finished_) return nullptr;
  if (worker_.joinable()) worker_.join();  // it has finished its work
  job_ = std::make_shared<TrainJob>(goal, bag_roots_);
  return job_;
}

void Trainer::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  job_.reset();
  goal_ = GoalHandle();
}

void Trainer::onGoal(GoalHandle handle) {
  const std::shared_ptr<TrainJob> job = begin(*handle.getGoal());
  if (!job) {
    TrainResult result;
    result.message = kBusy;
    handle.setRejected(result, kBusy);
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  goal_ = handle;
  handle.setAccepted();
  // A cancel that came before this lock did not find the goal here, but actionlib recorded it.
  if (handle.getGoalStatus().status == actionlib_msgs::GoalStatus::PREEMPTING) job->cancel();
  worker_ = std::thread([this, handle, job] { work(handle, job); });
}

void Trainer::onCancel(GoalHandle handle) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (job_ && goal_ == handle) job_->cancel();
}

void Trainer::work(GoalHandle handle, const std::shared_ptr<TrainJob>& job) {
  const auto on_feedback = [&handle](const TrainFeedback& feedback) {
    logFeedback(feedback);
    handle.publishFeedback(feedback);
  };
  TrainResult result = job->run(on_feedback, logWarning);
  if (result.success) reloadRecognizers(*handle.getGoal(), result);
  log(result);
  end();
  if (result.success) {
    handle.setSucceeded(result, result.message);
  } else if (job->cancelled()) {
    handle.setCanceled(result, result.message);
  } else {
    handle.setAborted(result, result.message);
  }
}

bool Trainer::onRetrain(Retrain::Request& request, Retrain::Response& response) {
  const auto goal = sameFields<TrainGoal>(request);  // Retrain.srv is generated from Train.action
  const std::shared_ptr<TrainJob> job = begin(goal);
  if (!job) {
    response.message = kBusy;
    return true;
  }
  TrainResult result = job->run(logFeedback, logWarning);
  if (result.success) reloadRecognizers(goal, result);
  log(result);
  end();
  response = sameFields<Retrain::Response>(result);
  return true;
}

void Trainer::reloadRecognizers(const TrainGoal& goal, TrainResult& result) {
  for (const std::string& recognizer : goal.recognizers) {
    const std::string problem = reload(recognizer, goal.model);
    result.message +=
        " " + recognizer + (problem.empty() ? " has loaded it." : " has not loaded it: " + problem);
  }
}

std::string Trainer::reload(const std::string& recognizer, const std::string& model) {
  ros::ServiceClient client = node_.serviceClient<LoadModel>(recognizer + "/" + names::kLoadModel);
  LoadModel call;
  call.request.name = model;
  if (!appears(client.getService())) {
    return "there is no service " + client.getService() + ".";
  }
  if (!client.call(call)) return client.getService() + " does not answer.";
  return call.response.success ? "" : call.response.message;
}

}  // namespace place_recognition
