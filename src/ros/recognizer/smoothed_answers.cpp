#include "ros/recognizer/smoothed_answers.h"

#include <cassert>
#include <utility>

namespace place_recognition {
namespace {

/// Gives `message` the place, and the probabilities of all places, that `answer` has.
void revise(const FilteredAnswer& answer, PlaceRecognition& message) {
  const auto rooms = answer.probabilities.head(static_cast<Eigen::Index>(message.places.size()));
  const double evidence = rooms.sum();
  Eigen::Index best = 0;
  rooms.maxCoeff(&best);
  for (std::size_t i = 0; i < message.places.size(); ++i) {
    message.places[i].probability = rooms[static_cast<Eigen::Index>(i)] / evidence;
  }
  message.place = message.places[static_cast<std::size_t>(best)].name;
  message.known = answer.place >= 0;
  message.confidence = rooms[best] / evidence;
  message.evidence = evidence;
  message.reason.clear();
}

}  // namespace

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
