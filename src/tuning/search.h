#pragma once

#include <optional>
#include <string>
#include <vector>

#include "place_recognition/tuning.h"
#include "tuning/score.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// What all stages of a search share: what is given, and what came of it so far.
struct Search {
  TuningRuns runs;
  const TrainingOptions& base;
  const SearchSpace& space;
  unsigned threads;
  const Progress& progress;

  std::string stage = {};
  std::vector<TuningTrial> trials = {};
  std::optional<TuningTrial> best = {};  ///< if the search ended now

  /// Notes a trial of the current stage.
  const TuningTrial& note(const std::vector<CueOptions>& cues, double c,
                          const TuningSamples& samples, const Score& score);

  /// `base` with other cues, and in the lights that are asked for.
  TrainingOptions withCues(const std::vector<CueOptions>& cues) const;
};

/// The first of `scores`, which stand in the order of preference, that is as good as the best: its
/// log loss is less than one standard error of the difference above the least.
std::size_t firstAsGood(const std::vector<Score>& scores, const TuningSamples& samples);

/// The same with the standard error of the least log loss itself, which is larger: for what hardly
/// matters on the same recording, as gamma, and whose extremes often fail on the next one.
std::size_t firstNearlyAsGood(const std::vector<Score>& scores);

}  // namespace place_recognition
