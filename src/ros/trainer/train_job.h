#pragma once

#include <place_recognition/TrainFeedback.h>
#include <place_recognition/TrainGoal.h>
#include <place_recognition/TrainResult.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace place_recognition {

/// One training, run by place_tool in a child process, so that neither its memory nor a crash
/// affects the trainer.
class TrainJob {
 public:
  using FeedbackCallback = std::function<void(const TrainFeedback&)>;
  /// A sentence about input that is ignored or may be used differently than intended.
  using WarningCallback = std::function<void(const std::string&)>;

  /// `bag_roots`: folders that may contain bags.
  TrainJob(const TrainGoal& goal, const std::vector<std::string>& bag_roots);

  /// Trains and returns when finished; the result's message contains an error, with the preceding
  /// warnings.
  TrainResult run(const FeedbackCallback& on_feedback, const WarningCallback& on_warning);

  /// Stops run(), now or as soon as it is called. Safe from any thread.
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }

 private:
  TrainResult train(const FeedbackCallback& on_feedback, const WarningCallback& on_warning);

  TrainGoal goal_;
  std::vector<std::string> bag_roots_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace place_recognition
