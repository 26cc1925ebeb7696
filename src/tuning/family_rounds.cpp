#include "tuning/family_rounds.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "tuning/cue_comparison.h"

namespace place_recognition {
namespace {

std::uint64_t countLabelled(const std::vector<RecordingOpener>& recordings,
                            const Progress& progress) {
  std::uint64_t count = 0;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const std::unique_ptr<Recording> recording = recordings[r]();
    for (Frame frame; recording->next(frame);) {
      count += frame.place.empty() ? 0 : 1;
      report(progress, "Counting images",
             (static_cast<double>(r) + recording->fraction()) /
                 static_cast<double>(recordings.size()));
    }
  }
  return count;
}

std::size_t stepTo(std::uint64_t images, int wanted) {
  return std::max<std::size_t>(1,
                               static_cast<std::size_t>(images) / static_cast<std::size_t>(wanted));
}

/// The progress of family number `index` as a part of `round`.
Progress partOfRound(const Search& search, const std::string& round, std::size_t index,
                     std::size_t families) {
  return [&search, round, index, families](const std::string&, double fraction) {
    const double done = (static_cast<double>(index) + fraction) / static_cast<double>(families);
    return !search.progress || search.progress("Looking for cues, " + round, done);
  };
}

/// The `count` best cues of a family, in the order in which they stood; for one, the simplest
/// within one standard error of the best.
std::vector<CueOptions> bestOf(const Family& family, std::size_t count, std::size_t step,
                               const std::string& round, const Progress& progress, Search& search) {
  if (family.cues.size() <= count) return family.cues;
  TuningSamples samples = search.collect(family.cues, step, progress);
  std::vector<Score> scores;
  for (std::size_t c = 0; c < family.cues.size(); ++c) {
    report(progress, "", 1);
    const CueComparison comparison(family.cues[c], std::move(samples.features[c]), samples,
                                   search.threads);
    scores.push_back(score(comparison.heldOut(search.base.svm, search.threads), samples));
    search.note(round, {family.cues[c]}, search.base.svm.c, samples, scores.back());
  }
  if (count == 1) return {family.cues[firstAsGood(scores, samples)]};

  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scores[a].log_loss < scores[b].log_loss;
  });
  order.resize(count);
  std::sort(order.begin(), order.end());
  std::vector<CueOptions> kept;
  for (const std::size_t c : order) kept.push_back(family.cues[c]);
  return kept;
}

}  // namespace

Thinning planThinning(const TuningRecordings& recordings, const SearchSpace& space,
                      const Progress& progress, std::uint64_t& images) {
  images =
      countLabelled(recordings.recordings, progress) + countLabelled(recordings.hold_out, progress);
  return {stepTo(images, space.first_pictures), stepTo(images, space.max_pictures)};
}

std::vector<CueOptions> bestOfEach(std::vector<Family> families, const Thinning& thinning,
                                   Search& search) {
  const bool one_round = thinning.first == thinning.last;
  const int rounds = one_round ? 1 : 2;
  std::size_t step = thinning.first;
  for (int round = 1; round <= rounds; ++round) {
    const std::string name = "round " + std::to_string(round) + " of " + std::to_string(rounds);
    for (std::size_t f = 0; f < families.size(); ++f) {
      const std::size_t count = round == rounds ? 1 : (families[f].cues.size() + 3) / 4;
      families[f].cues = bestOf(families[f], count, step, name,
                                partOfRound(search, name, f, families.size()), search);
    }
    step = std::max(thinning.last, step / 2);
  }
  std::vector<CueOptions> winners;
  for (const Family& family : families) winners.push_back(family.cues.front());
  return winners;
}

}  // namespace place_recognition
