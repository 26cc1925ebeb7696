#include "tuning/tuning_samples.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/place_name.h"
#include "recognition/training/block_choice.h"
#include "tuning/next_run.h"
#include "tuning/thinned_run.h"

namespace place_recognition {
namespace {

std::vector<RunOpener> thinnedOpeners(const TuningRuns& runs, std::size_t step,
                                      std::uint64_t seed) {
  constexpr std::uint64_t kSeedsOfRun = kMaxPlaces;  // one for each place
  std::vector<RunOpener> openers;
  for (const std::vector<RunOpener>* group : {&runs.runs, &runs.hold_out}) {
    for (const RunOpener& open : *group) {
      const std::uint64_t run_seed = seed + kSeedsOfRun * openers.size();
      openers.push_back([open, step, run_seed] { return thinOut(open(), step, run_seed); });
    }
  }
  return openers;
}

/// Reading one of many runs as a part of the whole.
Progress partOf(const Progress& whole, std::size_t runs, std::size_t& opened) {
  return [&whole, runs, &opened](const std::string&, double fraction) {
    if (fraction == 0) ++opened;
    const double done = static_cast<double>(opened) - 1 + fraction;
    return !whole || whole("Extracting features", done / static_cast<double>(runs));
  };
}

/// Runs that hold every place.
int completeRuns(const std::vector<SampleOrigin>& origins, std::size_t places) {
  std::map<int, std::set<int>> places_of_run;
  for (const SampleOrigin& origin : origins) places_of_run[origin.run].insert(origin.place);
  return static_cast<int>(
      std::count_if(places_of_run.begin(), places_of_run.end(),
                    [&](const auto& run) { return run.second.size() == places; }));
}

/// Folds of the recorded samples.
std::vector<Fold> recordedFolds(const Samples& samples, const TuningRuns& runs,
                                const TrainingOptions& options, unsigned threads) {
  const std::vector<SampleOrigin> origins = samples.recordedOrigins();
  if (!runs.hold_out.empty()) {
    Fold fold;
    for (std::size_t i = 0; i < origins.size(); ++i) {
      const bool trained_on = origins[i].run < static_cast<int>(runs.runs.size());
      (trained_on ? fold.train : fold.test).push_back(static_cast<int>(i));
    }
    return {fold};
  }
  const int complete = completeRuns(origins, samples.places.size());
  if (complete >= 2) {
    const int count = std::min(complete, options.validation.folds);
    return timeBlockFolds(origins, count, {});
  }
  return timeBlockFolds(
      origins, options.validation.folds,
      chooseBlocks(origins, samples.features, options.cues, options.validation, threads));
}

}  // namespace

TuningSamples collectTuningSamples(const TuningRuns& runs, const TrainingOptions& options,
                                   bool other_light, std::size_t step, unsigned threads,
                                   const Progress& progress) {
  const std::vector<RunOpener> openers = thinnedOpeners(runs, step, options.seed);
  std::size_t opened = 0;
  NextRun next_run(options.seed, other_light);
  const ImageChange change = [&next_run](const cv::Mat& image, const std::string& place) {
    return next_run.change(image, place);
  };
  TuningSamples samples{
      collectSamples(openers, options, threads, partOf(progress, openers.size(), opened), 2,
                     runs.images, change),
      {}};
  samples.folds = withCopies(recordedFolds(samples, runs, options, threads), samples.source, false);
  return samples;
}

}  // namespace place_recognition
