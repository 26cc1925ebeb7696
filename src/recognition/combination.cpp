#include "recognition/combination.h"

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
  for (std::size_t i = 0; i < combined.valid.size(); ++i) {
    double present = 0;
    for (std::size_t c = 0; c < cues.size(); ++c) {
      if (!cues[c].valid[i]) continue;
      combined.margins.row(i) += weights[c] * cues[c].margins.row(i);
      present += weights[c];
    }
    combined.valid[i] = present > 0;
    if (present > 0) combined.margins.row(i) /= present;
  }
  return combined;
}

std::vector<double> chooseCueWeights(const std::vector<HeldOut>& cues,
                                     const std::vector<SampleOrigin>& samples, std::size_t places) {
  const int steps = stepsFor(cues.size());
  std::vector<double> best;
  double best_rate = -1, best_norm = 0;
  std::vector<int> parts;
  forEachComposition(cues.size(), steps, parts, [&] {
    std::vector<double> weights;
    for (const int part : parts) weights.push_back(static_cast<double>(part) / steps);
    const double rate = averageRate(combine(cues, weights), samples, places);
    const double norm = squaredNorm(parts);
    if (rate < best_rate || (rate == best_rate && norm >= best_norm)) return;
    best = weights, best_rate = rate, best_norm = norm;
  });
  return best;
}

}  // namespace place_recognition
