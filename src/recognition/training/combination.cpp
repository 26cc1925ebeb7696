#include "recognition/training/combination.h"

#include <algorithm>
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

double squaredNorm(const std::vector<int>& parts) {
  double sum = 0;
  for (const int part : parts) sum += static_cast<double>(part) * part;
  return sum;
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

std::vector<double> chooseCueWeights(const std::vector<HeldOut>& cues,
                                     const std::vector<SampleOrigin>& samples, std::size_t places) {
  struct Trial {
    std::vector<double> weights;
    double norm, rate, error;
  };
  std::vector<Trial> trials;
  const int steps = stepsFor(cues.size());
  std::vector<int> parts;
  forEachComposition(cues.size(), steps, parts, [&] {
    Trial trial{{}, squaredNorm(parts), 0, 0};
    for (const int part : parts) trial.weights.push_back(static_cast<double>(part) / steps);
    const HeldOut combined = combine(cues, trial.weights);
    trial.rate = averageRate(combined, samples, places);
    trial.error = averageRateError(combined, samples, places);
    trials.push_back(std::move(trial));
  });

  const Trial best = *std::max_element(
      trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.rate < b.rate; });
  const Trial* chosen = nullptr;
  for (const Trial& trial : trials) {
    if (trial.rate < best.rate - best.error) continue;
    const bool better = !chosen || trial.norm < chosen->norm ||
                        (trial.norm == chosen->norm && trial.rate > chosen->rate);
    if (better) chosen = &trial;
  }
  return chosen->weights;
}

}  // namespace place_recognition
