#include "ros/recognizer/smoothed_answers.h"

#include <cassert>
#include <utility>

#include "ros/messages/conversions.h"

namespace place_recognition {
void SmoothedAnswers::follow(const Adjacency& adjacency, const TemporalFilterOptions& options) {
  finish();
  smoother_.emplace(adjacency, options, lag_);
}

void SmoothedAnswers::add(const TemporalFilter& filter, const PlaceRecognition& message) {
  assert(smoother_);
  smoother_->add(filter);
  waiting_.push_back(message);
  answer();
}

void SmoothedAnswers::finish() {
  if (!smoother_) return;
  smoother_->finish();
  answer();
}

void SmoothedAnswers::answer() {
  for (; smoother_->ready(); waiting_.pop_front()) {
    revise(smoother_->next(), waiting_.front());
    done_.push_back(std::move(waiting_.front()));
  }
}

void SmoothedAnswers::clear() {
  waiting_.clear();
  done_.clear();
  if (smoother_) smoother_->clear();
}

std::vector<PlaceRecognition> SmoothedAnswers::take() { return std::exchange(done_, {}); }

}  // namespace place_recognition
