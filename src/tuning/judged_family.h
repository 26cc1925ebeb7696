#pragma once

#include <string>
#include <vector>

#include "tuning/candidates.h"
#include "tuning/search.h"

namespace place_recognition {

/// One round in the comparison of families.
struct Round {
  std::string name;      ///< the stage of its trials
  std::size_t step = 1;  ///< one of `step` images of a place is used
};

/// The scores of a family's cues in one round.
struct JudgedFamily {
  std::vector<TuningTrial> trials;  ///< one for each cue
  std::vector<std::size_t> best;    ///< indices of the best cues, ascending
};

/// Scores the cues of `family` and finds the `count` best; if `count` is 1, the simplest within one
/// standard error of the best. The result is read from the search's cells if it is there; otherwise
/// it is computed and stored.
JudgedFamily judgeFamily(const Family& family, std::size_t count, const Round& round,
                         const Progress& progress, Search& search);

}  // namespace place_recognition
