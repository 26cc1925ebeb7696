#include "recognition/recognizer/cue_budget.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

namespace place_recognition {
namespace {

constexpr double kApproach = 0.2;          // of the way down to a cue's last time, per frame
constexpr double kKeptWhenLeftOut = 0.98;  // of a cue's expected time, per frame without it

}  // namespace

double CueBudget::steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

CueBudget::CueBudget(std::size_t cues, Clock clock)
    : clock_(std::move(clock)), expected_(cues, 0), computed_(cues, false), order_(cues) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
}

void CueBudget::begin(double seconds) {
  end_ = clock_() + seconds;
  for (std::size_t cue = 0; cue < expected_.size() && foreseen_ > 0; ++cue) {
    if (!computed_[cue]) remember(cue, expected_[cue] * spent_ / foreseen_);
  }
  computed_.assign(computed_.size(), false);
  spent_ = foreseen_ = 0;
  std::stable_sort(order_.begin(), order_.end(),
                   [this](std::size_t a, std::size_t b) { return expected_[a] < expected_[b]; });
}

bool CueBudget::fits(std::size_t cue) const { return clock_() + expected_[cue] <= end_; }

void CueBudget::leaveOut(std::size_t cue) { expected_[cue] *= kKeptWhenLeftOut; }

void CueBudget::finish(std::size_t cue, double seconds) {
  computed_[cue] = true;
  if (expected_[cue] > 0) {
    spent_ += seconds;
    foreseen_ += expected_[cue];
  }
  remember(cue, seconds);
}

void CueBudget::remember(std::size_t cue, double seconds) {
  double& expected = expected_[cue];
  expected = std::max(seconds, expected + kApproach * (seconds - expected));
}

}  // namespace place_recognition
