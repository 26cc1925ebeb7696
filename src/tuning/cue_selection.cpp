#include "tuning/cue_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "recognition/training/combination.h"

namespace place_recognition {
namespace {

/// Standard errors that a step away from the prior must gain. The best of some fifty steps gains
/// two by chance, and neighbouring images are less independent than the standard error assumes.
constexpr double kGainOfAStep = 4;

/// `values` in the order of their ratio to `centre`, the closest first.
std::vector<double> nearestFirst(std::vector<double> values, double centre) {
  std::stable_sort(values.begin(), values.end(), [centre](double a, double b) {
    return std::abs(std::log(a / centre)) < std::abs(std::log(b / centre));
  });
  return values;
}

std::vector<CueOptions> optionsOf(const std::vector<CueComparison>& comparisons,
                                  const Combination& combination) {
  std::vector<CueOptions> cues;
  for (const std::size_t c : combination) cues.push_back(comparisons[c].cue());
  return cues;
}

/// The held-out values of these cues together, with the weights that training prefers.
HeldOutValues combined(const std::vector<HeldOutValues>& held_out, TrainingOptions options,
                       const std::vector<CueOptions>& cues) {
  options.cues = cues;
  return combine(held_out, priorWeights(cues), decisionLimit(options));
}

Combination without(Combination combination, std::size_t cue) {
  combination.erase(std::remove(combination.begin(), combination.end(), cue), combination.end());
  return combination;
}

Combination with(Combination combination, std::size_t cue) {
  combination.insert(std::upper_bound(combination.begin(), combination.end(), cue), cue);
  return combination;
}

/// One step of the search.
struct Step {
  std::string name;
  Combination combination;
};

/// All steps from `current` with `cues` available cues, of which at most `max_cues` are combined.
std::vector<Step> stepsFrom(const Combination& current, std::size_t cues, std::size_t max_cues) {
  std::vector<Step> steps;
  for (std::size_t c = 0; c < cues; ++c) {
    const bool is_in = std::binary_search(current.begin(), current.end(), c);
    if (is_in && current.size() > 1) steps.push_back({"one less", without(current, c)});
    if (is_in) continue;
    if (current.size() < max_cues) steps.push_back({"one more", with(current, c)});
    for (const std::size_t other : current) {
      steps.push_back({"another", with(without(current, other), c)});
    }
  }
  return steps;
}

}  // namespace

Combination chooseCues(const std::vector<CueComparison>& comparisons, std::size_t prior,
                       const TuningSamples& samples, Search& search) {
  std::vector<HeldOutValues> held_out;
  for (const CueComparison& comparison : comparisons) {
    report(search.progress, "Judging cues",
           static_cast<double>(held_out.size()) / static_cast<double>(comparisons.size()));
    held_out.push_back(comparison.heldOut(search.base.svm, search.threads));
  }
  const auto judge = [&](const std::string& stage, const Combination& combination) {
    std::vector<HeldOutValues> of_these;
    for (const std::size_t c : combination) of_these.push_back(held_out[c]);
    const std::vector<CueOptions> cues = optionsOf(comparisons, combination);
    const Score result = score(combined(of_these, search.base, cues), samples);
    search.trials.push_back(trialOf(stage, cues, search.base.svm.c, samples, result));
    return result;
  };

  Combination current(prior);
  std::iota(current.begin(), current.end(), 0);
  Score reached = judge("start", current);
  search.best = search.trials.back();
  for (;;) {
    const std::vector<Step> steps =
        stepsFrom(current, comparisons.size(), static_cast<std::size_t>(search.space.max_cues));
    std::vector<Score> scores;
    const std::size_t first_trial = search.trials.size();
    for (const Step& step : steps) {
      report(search.progress, "Combining cues",
             static_cast<double>(scores.size()) / static_cast<double>(steps.size()));
      scores.push_back(judge(step.name, step.combination));
    }
    if (scores.empty()) return current;
    const std::size_t best = leastOf(scores);
    const double gain = reached.log_loss - scores[best].log_loss;
    if (gain <= kGainOfAStep * differenceError(reached, scores[best], samples)) return current;
    reached = scores[best];
    current = steps[best].combination;
    search.best = search.trials[first_trial + best];
  }
}

void chooseC(const std::vector<CueComparison>& comparisons, const Combination& chosen,
             const TuningSamples& samples, Search& search) {
  const std::vector<double> values = nearestFirst(search.space.c, search.base.svm.c);
  const std::vector<CueOptions> cues = optionsOf(comparisons, chosen);
  const std::size_t first_trial = search.trials.size();
  std::vector<Score> scores;
  for (const double c : values) {
    report(search.progress, "Choosing C",
           static_cast<double>(scores.size()) / static_cast<double>(values.size()));
    SvmOptions svm = search.base.svm;
    svm.c = c;
    std::vector<HeldOutValues> held_out;
    for (const std::size_t cue : chosen) {
      held_out.push_back(comparisons[cue].heldOut(svm, search.threads));
    }
    scores.push_back(score(combined(held_out, search.base, cues), samples));
    search.trials.push_back(trialOf("C", cues, c, samples, scores.back()));
  }
  search.best = search.trials[first_trial + firstNearlyAsGood(scores)];
}

}  // namespace place_recognition
