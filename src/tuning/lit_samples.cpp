#include "tuning/lit_samples.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "recognition/samples.h"
#include "tuning/thinned_run.h"

namespace place_recognition {
namespace {

/// All runs in the first light, then all in the second, and so on.
std::vector<RunOpener> openersInLights(const TuningRuns& runs, std::size_t step,
                                       const std::vector<Light>& lights) {
  std::vector<RunOpener> openers;
  for (const Light& light : lights) {
    for (const std::vector<RunOpener>* group : {&runs.runs, &runs.hold_out}) {
      for (const RunOpener& open : *group) {
        openers.push_back([open, step, light] { return thinOut(open(), step, light); });
      }
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

/// Of each sample the first one of the same place, run and stamp among the recorded ones; turns
/// run numbers into those of the recordings.
void findSources(LitSamples& samples, int runs) {
  std::map<std::pair<int, double>, int> recorded;
  for (SampleOrigin& origin : samples.origins) {
    const bool as_recorded = origin.run < runs;
    origin.run %= runs;
    const std::pair<int, double> key{origin.run, origin.stamp};
    const int own = static_cast<int>(samples.source.size());
    if (as_recorded) {
      recorded.emplace(key, own);
      samples.source.push_back(own);
      ++samples.recorded;
    } else {
      const auto found = recorded.find(key);
      samples.source.push_back(found == recorded.end() ? -1 : found->second);
    }
  }
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
std::vector<Fold> recordedFolds(const LitSamples& samples, const TuningRuns& runs,
                                const ValidationOptions& validation) {
  const std::vector<SampleOrigin> origins(
      samples.origins.begin(), samples.origins.begin() + static_cast<long>(samples.recorded));
  if (!runs.hold_out.empty()) {
    Fold fold;
    for (std::size_t i = 0; i < origins.size(); ++i) {
      const bool trained_on = origins[i].run < static_cast<int>(runs.runs.size());
      (trained_on ? fold.train : fold.test).push_back(static_cast<int>(i));
    }
    return {fold};
  }
  const int complete = completeRuns(origins, samples.places.size());
  const int count = complete >= 2 ? std::min(complete, validation.folds) : validation.folds;
  return timeBlockFolds(origins, count, validation.gap);
}

/// Adds to what is tested the same pictures in other light.
void testInEveryLight(LitSamples& samples) {
  std::vector<std::vector<int>> copies(samples.recorded);
  for (std::size_t i = samples.recorded; i < samples.source.size(); ++i) {
    if (samples.source[i] >= 0) copies[samples.source[i]].push_back(static_cast<int>(i));
  }
  for (Fold& fold : samples.folds) {
    const std::vector<int> recorded = fold.test;
    for (const int i : recorded) {
      fold.test.insert(fold.test.end(), copies[i].begin(), copies[i].end());
    }
  }
}

}  // namespace

LitSamples collectLitSamples(const TuningRuns& runs, const TrainingOptions& options,
                             std::size_t step, const std::vector<Light>& lights, unsigned threads,
                             const Progress& progress) {
  const std::vector<RunOpener> openers = openersInLights(runs, step, lights);
  std::size_t opened = 0;
  Samples collected =
      collectSamples(openers, options, threads, partOf(progress, openers.size(), opened));
  LitSamples samples;
  samples.places = std::move(collected.places);
  samples.origins = std::move(collected.origins);
  samples.features = std::move(collected.features);
  findSources(samples, static_cast<int>(runs.runs.size() + runs.hold_out.size()));
  samples.folds = recordedFolds(samples, runs, options.validation);
  testInEveryLight(samples);
  return samples;
}

}  // namespace place_recognition
