#include "tuning/judged_family.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "base/options.h"
#include "tuning/cue_comparison.h"

namespace place_recognition {
namespace {

/// To be incremented when results change, so that cells of an older program are not reused.
constexpr int kVersion = 1;

/// Indices of the `count` least log losses, ascending. For one: the first that is as good as the
/// least.
std::vector<std::size_t> bestOf(const std::vector<Score>& scores, std::size_t count,
                                const TuningSamples& samples) {
  if (count == 1) return {firstAsGood(scores, samples)};
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a].log_loss < scores[b].log_loss;
  });
  order.resize(count);
  std::sort(order.begin(), order.end());
  return order;
}

JudgedFamily compute(const Family& family, std::size_t count, const Round& round,
                     const Progress& progress, const Search& search) {
  TuningSamples samples = search.collect(family.cues, round.step, progress);
  JudgedFamily judged;
  std::vector<Score> scores;
  for (std::size_t c = 0; c < family.cues.size(); ++c) {
    report(progress, "", 1);
    const CueComparison comparison(family.cues[c], std::move(samples.features[c]), samples,
                                   search.threads);
    scores.push_back(score(comparison.heldOut(search.base.svm, search.threads), samples));
    judged.trials.push_back(
        trialOf(round.name, {family.cues[c]}, search.base.svm.c, samples, scores.back()));
  }
  judged.best = bestOf(scores, count, samples);
  return judged;
}

/// Everything the result depends on.
Json keyOf(const Family& family, std::size_t count, const Round& round, const Search& search) {
  return {{"images", search.images.digest},
          {"step", round.step},
          {"options", writeOptions(withCues(search.base, family.cues))},
          {"other_light", search.space.other_light},
          {"best", count},
          {"version", kVersion}};
}

Json cellOf(const JudgedFamily& judged) {
  Json trials = Json::array();
  for (const TuningTrial& trial : judged.trials) {
    trials.push_back({trial.images, trial.log_loss, trial.rate, trial.changed_rate});
  }
  return {{"trials", trials}, {"best", judged.best}};
}

JudgedFamily fromCell(const Json& cell, const Family& family, const Round& round,
                      const Search& search) {
  JudgedFamily judged;
  for (const Json& figures : cell.at("trials")) {
    judged.trials.push_back({round.name,
                             {family.cues[judged.trials.size()]},
                             search.base.svm.c,
                             figures.at(0),
                             figures.at(1),
                             figures.at(2),
                             figures.at(3)});
  }
  judged.best = cell.at("best").get<std::vector<std::size_t>>();
  return judged;
}

}  // namespace

JudgedFamily judgeFamily(const Family& family, std::size_t count, const Round& round,
                         const Progress& progress, Search& search) {
  if (!search.cells) return compute(family, count, round, progress, search);
  const Json key = keyOf(family, count, round, search);
  ++search.used_cells;
  if (const std::optional<Json> cell = search.cells->find(key)) {
    return fromCell(*cell, family, round, search);
  }
  JudgedFamily judged = compute(family, count, round, progress, search);
  search.cells->save(key, cellOf(judged));
  ++search.computed_cells;
  return judged;
}

}  // namespace place_recognition
