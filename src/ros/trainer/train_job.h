#pragma once

#include <place_recognition/TrainFeedback.h>
#include <place_recognition/TrainGoal.h>
#include <place_recognition/TrainResult.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace place_recognition {

/// One training, done by place_tool in a child process, so that neither its memory nor a crash is
/// the trainer's.
class TrainJob {
 public:
  using FeedbackCallback = std::function<void(const TrainFeedback&)>;
  /// A sentence on what is used otherwise than it may be meant, or not at all.
  using WarningCallback = std::function<void(const std::string&)>;

  /// `bag_roots`: the folders below which bags may lie.
  TrainJob(const TrainGoal& goal, const std::vector<std::string>& bag_roots);

  /// Trains and returns when it is over; what went wrong is in the result's message, with the
  /// warnings that came before.
  TrainResult run(const FeedbackCallback& on_feedback, const WarningCallback& on_warning);

  /// Stops run(), now or as soon as it is called. From any thread.
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }

 private:
  TrainResult train(const FeedbackCallback& on_feedback, const WarningCallback& on_warning);

  TrainGoal goal_;
  std::vector<std::string> bag_roots_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace place_recognition
