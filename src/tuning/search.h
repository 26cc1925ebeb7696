#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/cell_store.h"
#include "place_recognition/tuning.h"
#include "tuning/recorded_images.h"
#include "tuning/score.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// What all stages of a search share: what is given, and what came of it so far.
struct Search {
  TuningRecordings recordings;
  RecordedImages images;
  TrainingOptions base;
  SearchSpace space;
  unsigned threads;
  const Progress& progress;
  std::optional<CellStore> cells;  ///< results of judgeFamily(); none: they are not kept

  std::vector<TuningTrial> trials = {};
  TuningTrial best = {};           ///< if the search ended now
  std::size_t used_cells = 0;      ///< of `cells`, whether found or computed
  std::size_t computed_cells = 0;  ///< those that were not found

  /// Features of `cues` of about one of `step` images.
  TuningSamples collect(const std::vector<CueOptions>& cues, std::size_t step,
                        const Progress& collect_progress) const;
};

TuningTrial trialOf(const std::string& stage, const std::vector<CueOptions>& cues, double c,
                    const TuningSamples& samples, const Score& score);

/// `options` with other cues.
TrainingOptions withCues(TrainingOptions options, const std::vector<CueOptions>& cues);

/// The index of the least log loss.
std::size_t leastOf(const std::vector<Score>& scores);

/// The first of `scores`, which stand in the order of preference, that is as good as the best: its
/// log loss is less than one standard error of the difference above the least.
std::size_t firstAsGood(const std::vector<Score>& scores, const TuningSamples& samples);

/// The same with the standard error of the least log loss itself, which is larger: for what hardly
/// matters on the same recording, as gamma, and whose extremes often fail on the next one.
std::size_t firstNearlyAsGood(const std::vector<Score>& scores);

}  // namespace place_recognition
