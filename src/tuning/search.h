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

/// The inputs and intermediate results that all stages of a search share.
struct Search {
  TuningRecordings recordings;
  RecordedImages images;
  TrainingOptions base;
  SearchSpace space;
  unsigned threads;
  const Progress& progress;
  std::optional<CellStore> cells;  ///< stored results of judgeFamily(), if they are kept

  std::vector<TuningTrial> trials = {};
  TuningTrial best = {};           ///< the best configuration so far
  std::size_t used_cells = 0;      ///< number of `cells` used, found or computed
  std::size_t computed_cells = 0;  ///< number of cells that were not found

  /// Features of `cues` of about one in `step` images.
  TuningSamples collect(const std::vector<CueOptions>& cues, std::size_t step,
                        const Progress& collect_progress) const;
};

TuningTrial trialOf(const std::string& stage, const std::vector<CueOptions>& cues, double c,
                    const TuningSamples& samples, const Score& score);

/// `options` with other cues.
TrainingOptions withCues(TrainingOptions options, const std::vector<CueOptions>& cues);

/// The index of the score with the least log loss.
std::size_t leastOf(const std::vector<Score>& scores);

/// The first of `scores`, which are in order of preference, that is as good as the best: its log
/// loss exceeds the least by less than one standard error of the difference.
std::size_t firstAsGood(const std::vector<Score>& scores, const TuningSamples& samples);

/// The same with the standard error of the least log loss itself, which is larger. It suits options
/// that hardly matter within a recording but whose extremes often fail on the next one, such as
/// gamma.
std::size_t firstNearlyAsGood(const std::vector<Score>& scores);

}  // namespace place_recognition
