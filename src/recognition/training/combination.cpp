#include "recognition/training/combination.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace place_recognition {
namespace {

/// Calls `visit` with every vector of `count` non-negative integers of the sum `total`.
void forEachComposition(std::size_t count, int total, std::vector<int>& parts,
                        const std::function<void()>& visit) {
  if (parts.size() + 1 == count) {
    parts.push_back(total);
    visit();
    parts.pop_back();
    return;
  }
  for (int part = 0; part <= total; ++part) {
    parts.push_back(part);
    forEachComposition(count, total - part, parts, visit);
    parts.pop_back();
  }
}

/// Steps of the grid that keep it below about a thousand points.
int stepsFor(std::size_t cues) { return cues <= 3 ? 10 : cues == 4 ? 8 : 4; }

/// In steps that rounding errors do not reach.
std::int64_t squaredDistance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::llround(1e9 * sum);
}

}  // namespace

HeldOut combine(const std::vector<HeldOut>& cues, const std::vector<double>& weights) {
  HeldOut combined;
  combined.margins.setZero(cues[0].margins.rows(), cues[0].margins.cols());
  combined.valid.assign(cues[0].valid.size(), false);
  combined.familiarity.setZero(cues[0].margins.rows());
  for (std::size_t i = 0; i < combined.valid.size(); ++i) {
    double present = 0;
    for (std::size_t c = 0; c < cues.size(); ++c) {
      if (!cues[c].valid[i]) continue;
      combined.margins.row(i) += weights[c] * cues[c].margins.row(i);
      if (cues[c].familiarity.size() > 0) {
        combined.familiarity[i] += weights[c] * cues[c].familiarity[i];
      }
      present += weights[c];
    }
    combined.valid[i] = present > 0;
    if (present > 0) {
      combined.margins.row(i) /= present;
      combined.familiarity[i] /= present;
    }
  }
  return combined;
}

std::vector<double> priorWeights(const std::vector<CueOptions>& cues) {
  double sum = 0;
  for (const CueOptions& cue : cues) sum += cue.weight;
  std::vector<double> weights;
  for (const CueOptions& cue : cues) weights.push_back(cue.weight / sum);
  return weights;
}

std::vector<double> chooseCueWeights(const std::vector<HeldOut>& cues,
                                     const std::vector<double>& prior,
                                     const std::vector<SampleOrigin>& samples, std::size_t places) {
  struct Trial {
    std::vector<double> weights;
    std::int64_t distance;
    double rate, error;
  };
  std::vector<Trial> trials;
  const auto judge = [&](const std::vector<double>& weights) {
    const HeldOut combined = combine(cues, weights);
    trials.push_back({weights, squaredDistance(weights, prior),
                      averageRate(combined, samples, places),
                      averageRateError(combined, samples, places)});
  };
  judge(prior);
  const int steps = stepsFor(cues.size());
  std::vector<int> parts;
  forEachComposition(cues.size(), steps, parts, [&] {
    std::vector<double> weights;
    for (const int part : parts) weights.push_back(static_cast<double>(part) / steps);
    judge(weights);
  });

  const Trial best = *std::max_element(
      trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.rate < b.rate; });
  const Trial* chosen = nullptr;
  for (const Trial& trial : trials) {
    if (trial.rate < best.rate - best.error) continue;
    const bool better = !chosen || trial.distance < chosen->distance ||
                        (trial.distance == chosen->distance && trial.rate > chosen->rate);
    if (better) chosen = &trial;
  }
  return chosen->weights;
}

}  // namespace place_recognition
