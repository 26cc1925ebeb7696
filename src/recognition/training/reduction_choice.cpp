#include "recognition/training/reduction_choice.h"

#include <algorithm>
#include <iterator>

#include "learning/reduction.h"
#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxSamplesForAuto = 4000;
constexpr double kFractions[] = {0.70, 0.50, 0.35, 0.25, 0.15};

/// Compares the log losses of held-out samples between two reductions.
class LossComparison {
 public:
  LossComparison(const HeldOutValues& reference, const std::vector<SampleOrigin>& samples,
                 std::size_t places)
      : samples_(samples), places_(places) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!reference.valid[i]) continue;
      valid_.push_back(static_cast<int>(i));
      truth_.push_back(samples[i].place);
    }
    reference_ = logLosses(reference, samples, valid_);
  }

  /// Whether every place has enough samples to show that its vectors are needed.
  bool judgesEveryPlace() const {
    constexpr std::ptrdiff_t kEnough = 5;
    for (int place = 0; place < static_cast<int>(places_); ++place) {
      if (std::count(truth_.begin(), truth_.end(), place) < kEnough) return false;
    }
    return true;
  }

  /// Mean of the rooms' mean differences: the loss of `reduced`.
  RoomMean loss(const HeldOutValues& reduced) const {
    std::vector<double> differences = logLosses(reduced, samples_, valid_);
    for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= reference_[i];
    return roomMean(truth_, differences, places_);
  }

 private:
  const std::vector<SampleOrigin>& samples_;
  std::size_t places_;
  std::vector<int> valid_, truth_;
  std::vector<double> reference_;
};

}  // namespace

std::vector<ReductionOptions> reductionsInQuestion(const ReductionOptions& options,
                                                   std::size_t samples) {
  if (options.method != "auto") return {options};
  ReductionOptions reduction = options;
  reduction.method = "none";
  std::vector<ReductionOptions> reductions{reduction};
  if (samples > kMaxSamplesForAuto) return reductions;
  // In reverse, because of equally good reductions the first is chosen: one with a shared basis.
  for (auto method = std::crbegin(kReductionMethods); method != std::crend(kReductionMethods);
       ++method) {
    reduction.method = *method;
    for (const double fraction : kFractions) {
      reduction.share = fraction;
      reductions.push_back(reduction);
    }
  }
  return reductions;
}

std::size_t chooseReduction(const std::vector<ReductionOptions>& reductions,
                            const std::vector<CombinedValues>& held_out,
                            const std::vector<SampleOrigin>& samples, std::size_t places) {
  const LossComparison comparison(held_out[0], samples, places);
  if (!comparison.judgesEveryPlace()) return 0;
  const double full_rate = averageRate(held_out[0], samples, places);
  std::size_t chosen = 0;
  double chosen_loss = 0;
  bool holds = true;
  for (std::size_t r = 1; r < reductions.size(); ++r) {
    const RoomMean loss = comparison.loss(held_out[r]);
    const bool another_method = reductions[r].method != reductions[r - 1].method;
    const bool no_loss = loss.mean <= 0 && averageRate(held_out[r], samples, places) >= full_rate;
    holds = (holds || another_method) && no_loss;
    const double fraction = reductions[r].share;
    const double smallest = chosen == 0 ? 1 : reductions[chosen].share;
    if (holds && (fraction < smallest || (fraction == smallest && loss.mean < chosen_loss))) {
      chosen = r;
      chosen_loss = loss.mean;
    }
  }
  return chosen;
}

}  // namespace place_recognition
