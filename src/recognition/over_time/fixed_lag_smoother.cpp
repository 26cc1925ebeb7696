#include "place_recognition/fixed_lag_smoother.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "place_recognition/error.h"
#include "recognition/over_time/transition_model.h"

namespace place_recognition {

FixedLagSmoother::FixedLagSmoother(const Adjacency& adjacency, const TemporalFilterOptions& options,
                                   double lag)
    : minimum_confidence_(options.minimum_confidence), lag_(lag) {
  if (!(lag >= 0)) throw Error("The lag is " + std::to_string(lag) + " s; give 0 s or more.");
  options.check();
  chain_ = std::make_unique<TransitionModel>(adjacency, options.unknown_share, options.jump_share);
}

FixedLagSmoother::~FixedLagSmoother() = default;

void FixedLagSmoother::add(const TemporalFilter& filter) {
  seen_.push_back({filter.step_, filter.answer().probabilities});
  finished_ = false;
}

/// One past the last frame that provides information about the oldest one.
std::size_t FixedLagSmoother::windowEnd() const {
  const std::size_t last = std::min(seen_.size(), kMaxFrames);
  std::size_t end = 1;
  while (end < last && !seen_[end].step.first &&
         seen_[end].step.stamp - seen_.front().step.stamp <= lag_) {
    ++end;
  }
  return end;
}

bool FixedLagSmoother::ready() const {
  if (seen_.empty()) return false;
  return finished_ || windowEnd() < seen_.size();
}

const FilteredAnswer& FixedLagSmoother::next() {
  assert(ready());
  const Seen& frame = seen_.front();
  beta_.setOnes(frame.belief.size());
  for (std::size_t i = windowEnd() - 1; i > 0; --i) {
    beta_.array() *= seen_[i].step.likelihoods.array();
    chain_->goBack(seen_[i].step.changes, beta_);
  }
  answer_.probabilities = frame.belief.cwiseProduct(beta_);
  answer_.probabilities /= answer_.probabilities.sum();

  const int unknown = static_cast<int>(beta_.size()) - 1;
  const int best = answeredState(answer_.probabilities, minimum_confidence_);
  const int place = best == unknown ? -1 : best;
  answer_.changed = frame.step.first || place != answer_.place;
  answer_.place = place;
  answer_.confidence = answer_.probabilities[best];
  seen_.pop_front();
  return answer_;
}

}  // namespace place_recognition
