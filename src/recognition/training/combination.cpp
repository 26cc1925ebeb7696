#include "recognition/training/combination.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "recognition/model/cue_mean.h"

namespace place_recognition {
namespace {

/// Calls `visit` with every vector of `count` non-negative integers with the sum `total`.
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

/// Number of vectors that forEachComposition() visits: the binomial of count + total - 1 over
/// total.
double compositions(std::size_t count, int total) {
  double number = 1;
  for (int k = 1; k <= total; ++k) number *= (static_cast<double>(count) - 1 + k) / k;
  return std::round(number);
}

/// Steps from a share of 0 to 1 that keep the grid within kMaxGrid, but at least one.
int stepsFor(std::size_t cues) {
  constexpr double kMaxGrid = 1001;  // eleven cues in quarters
  int steps = cues <= 3 ? 10 : cues <= 5 ? 8 : 4;
  while (steps > 1 && compositions(cues, steps) > kMaxGrid) --steps;
  return steps;
}

/// The prior weights multiplied by the shares, with sum 1.
std::vector<double> scaled(const std::vector<double>& prior, const std::vector<double>& parts) {
  std::vector<double> weights(prior.size());
  std::transform(prior.begin(), prior.end(), parts.begin(), weights.begin(),
                 std::multiplies<double>());
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The rate with given shares of the cues.
struct Trial {
  std::vector<double> parts;
  RoomMean rate;
};

/// The sum of all shares that are as good as the best; zero for a cue with hardly any share.
std::vector<double> sumOfTheBest(const std::vector<Trial>& trials) {
  constexpr double kAsGood = 2;     // standard errors
  constexpr double kNothing = 0.2;  // of an equal share
  const Trial& best =
      *std::max_element(trials.begin(), trials.end(),
                        [](const auto& a, const auto& b) { return a.rate.mean < b.rate.mean; });
  const std::size_t cues = best.parts.size();
  std::vector<double> sums(cues, 0);
  double count = 0;
  for (const Trial& trial : trials) {
    if (trial.rate.mean < best.rate.mean - kAsGood * best.rate.standard_error) continue;
    for (std::size_t c = 0; c < cues; ++c) sums[c] += trial.parts[c];
    count += 1;
  }
  const double even = 1 / static_cast<double>(cues);
  for (double& sum : sums) sum = sum < kNothing * even * count ? 0 : sum;
  return sums;
}

}  // namespace

double decisionLimit(const TrainingOptions& options) {
  constexpr double kLimit = 2;
  return options.cues.size() > 1 && options.svm.multiclass == "one-against-all" ? kLimit : 0;
}

CombinedValues combine(const std::vector<HeldOutValues>& cues, const std::vector<double>& weights,
                       double limit) {
  const Eigen::Index places = cues[0].decision_values.cols();
  CombinedValues combined;
  combined.decision_values.setZero(cues[0].decision_values.rows(), places);
  combined.unlimited = combined.decision_values;
  combined.valid.assign(cues[0].valid.size(), false);
  combined.familiarity.setZero(cues[0].decision_values.rows());
  CueMean mean(limit);
  for (std::size_t i = 0; i < combined.valid.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    mean.begin(places);
    for (std::size_t c = 0; c < cues.size(); ++c) {
      if (!cues[c].valid[i]) continue;
      mean.add(weights[c], cues[c].decision_values.row(row), cues[c].familiarity[row]);
    }
    combined.valid[i] = mean.finish();
    combined.decision_values.row(row) = mean.decisionValues();
    combined.unlimited.row(row) = mean.unlimited();
    combined.familiarity[row] = mean.familiarity();
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

std::vector<std::vector<double>> gridOfShares(std::size_t cues) {
  std::vector<std::vector<double>> grid{std::vector<double>(cues, 1 / static_cast<double>(cues))};
  const int steps = stepsFor(cues);
  std::vector<int> counts;
  forEachComposition(cues, steps, counts, [&] {
    grid.emplace_back();
    for (const int count : counts) grid.back().push_back(static_cast<double>(count) / steps);
  });
  return grid;
}

std::vector<double> chooseCueWeights(const std::vector<HeldOutValues>& cues,
                                     const std::vector<double>& prior, double limit,
                                     const std::vector<SampleOrigin>& samples, std::size_t places) {
  const auto judge = [&](const std::vector<double>& parts) -> Trial {
    const CombinedValues combined = combine(cues, scaled(prior, parts), limit);
    return {parts, roomRates(combined, samples, places)};
  };
  std::vector<Trial> trials;
  for (const std::vector<double>& parts : gridOfShares(cues.size())) trials.push_back(judge(parts));
  std::vector<double> weights = scaled(prior, sumOfTheBest(trials));
  // Cues with the same information get the same weight, regardless of rounding errors of the sums.
  for (double& weight : weights) weight = std::round(1e12 * weight) / 1e12;
  return weights;
}

}  // namespace place_recognition
