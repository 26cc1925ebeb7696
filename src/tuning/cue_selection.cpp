#include "tuning/cue_selection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "recognition/training/combination.h"

namespace place_recognition {
namespace {

/// Standard errors that a further cue must gain: it costs time in every frame, and what the same
/// pictures say for it is partly their own noise.
constexpr double kGainOfACue = 2;

/// `values` by their ratio to `centre`, the nearest first.
std::vector<double> nearestFirst(std::vector<double> values, double centre) {
  std::stable_sort(values.begin(), values.end(), [centre](double a, double b) {
    return std::abs(std::log(a / centre)) < std::abs(std::log(b / centre));
  });
  return values;
}

std::vector<double> gammasOf(const CueComparison& comparison, const SearchSpace& space) {
  if (!comparison.gammaIsFree()) return {comparison.neutralGamma()};
  std::vector<double> gammas;
  for (const double factor : nearestFirst(space.gamma_factors, 1)) {
    gammas.push_back(factor * comparison.neutralGamma());
  }
  return gammas;
}

std::vector<CueOptions> optionsOf(const std::vector<CueChoice>& choices) {
  std::vector<CueOptions> cues;
  for (const CueChoice& choice : choices) {
    cues.push_back(choice.comparison->withGamma(choice.gamma));
  }
  return cues;
}

HeldOut combineEqually(const std::vector<HeldOut>& cues) {
  return combine(cues, std::vector<double>(cues.size(), 1 / static_cast<double>(cues.size())));
}

std::vector<HeldOut> heldOutOf(const std::vector<CueChoice>& choices) {
  std::vector<HeldOut> held_out;
  for (const CueChoice& choice : choices) held_out.push_back(choice.held_out);
  return held_out;
}

}  // namespace

std::vector<CueChoice> chooseGammas(const std::vector<CueComparison>& comparisons,
                                    const TuningSamples& samples, Search& search) {
  search.stage = "gamma";
  search.best.reset();
  std::vector<CueChoice> choices;
  for (const CueComparison& comparison : comparisons) {
    report(search.progress, "Choosing gamma",
           static_cast<double>(choices.size()) / static_cast<double>(comparisons.size()));
    const std::vector<double> gammas = gammasOf(comparison, search.space);
    std::vector<HeldOut> held_out;
    std::vector<Score> scores;
    std::vector<TuningTrial> trials;
    for (const double gamma : gammas) {
      held_out.push_back(comparison.heldOut(gamma, search.base.svm, search.threads));
      scores.push_back(score(held_out.back(), samples));
      trials.push_back(
          search.note({comparison.withGamma(gamma)}, search.base.svm.c, samples, scores.back()));
    }
    const std::size_t chosen = firstNearlyAsGood(scores);
    choices.push_back({&comparison, gammas[chosen], std::move(held_out[chosen]), scores[chosen]});
    const bool best = !search.best || trials[chosen].log_loss < search.best->log_loss;
    if (best) search.best = trials[chosen];
  }
  return choices;
}

std::vector<CueChoice> chooseCues(std::vector<CueChoice> choices, const TuningSamples& samples,
                                  Search& search) {
  const auto best = std::min_element(
      choices.begin(), choices.end(),
      [](const CueChoice& a, const CueChoice& b) { return a.score.log_loss < b.score.log_loss; });
  std::vector<CueChoice> chosen{std::move(*best)};
  choices.erase(best);
  Score current = chosen.front().score;

  while (static_cast<int>(chosen.size()) < search.space.max_cues && !choices.empty()) {
    search.stage = "cue " + std::to_string(chosen.size() + 1);
    std::vector<Score> scores;
    std::vector<TuningTrial> trials;
    for (const CueChoice& choice : choices) {
      report(search.progress, "Combining cues",
             static_cast<double>(scores.size()) / static_cast<double>(choices.size()));
      std::vector<CueChoice> combination = chosen;
      combination.push_back(choice);
      scores.push_back(score(combineEqually(heldOutOf(combination)), samples));
      trials.push_back(
          search.note(optionsOf(combination), search.base.svm.c, samples, scores.back()));
    }
    const auto least =
        std::min_element(scores.begin(), scores.end(),
                         [](const Score& a, const Score& b) { return a.log_loss < b.log_loss; });
    const double gain = current.log_loss - least->log_loss;
    if (gain <= kGainOfACue * differenceError(current, *least, samples)) break;
    const auto index = least - scores.begin();
    current = *least;
    search.best = trials[static_cast<std::size_t>(index)];
    chosen.push_back(std::move(choices[static_cast<std::size_t>(index)]));
    choices.erase(choices.begin() + index);
  }
  return chosen;
}

double chooseC(const std::vector<CueChoice>& chosen, const TuningSamples& samples, Search& search) {
  search.stage = "C";
  const std::vector<double> values = nearestFirst(search.space.c, search.base.svm.c);
  std::vector<Score> scores;
  std::vector<TuningTrial> trials;
  for (const double c : values) {
    report(search.progress, "Choosing C",
           static_cast<double>(scores.size()) / static_cast<double>(values.size()));
    SvmOptions svm = search.base.svm;
    svm.c = c;
    std::vector<HeldOut> held_out;
    for (const CueChoice& choice : chosen) {
      held_out.push_back(choice.comparison->heldOut(choice.gamma, svm, search.threads));
    }
    scores.push_back(score(combineEqually(held_out), samples));
    trials.push_back(search.note(optionsOf(chosen), c, samples, scores.back()));
  }
  const std::size_t index = firstNearlyAsGood(scores);
  search.best = trials[index];
  return values[index];
}

}  // namespace place_recognition
