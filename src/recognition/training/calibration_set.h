#pragma once

#include <cstdint>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/model.h"
#include "recognition/training/held_out_values.h"

namespace place_recognition {

/// The frames on which a model is validated: held-out decision values of the samples that it learns
/// now, followed by frames from earlier validations.
struct CalibrationSet {
  std::vector<SampleOrigin> samples;
  std::vector<Fold> folds;                             ///< only the test sets
  std::vector<std::vector<HeldOutValues>> reductions;  ///< [reduction][cue]
  std::vector<bool> judges_unknown;                    ///< samples that "unknown" is fitted to

  /// Adds frames that an earlier training held out; `place_of` maps their places to the current
  /// ones. They have no decision value for a new place. It is set to the mean decision value for
  /// that place over the first `remembered` samples that show their own place, or to -1 if there
  /// are none.
  void add(const HeldOutFrames& frames, const std::vector<int>& place_of, std::size_t remembered);
};

/// The frames of the calibration set that "unknown" is fitted to and that are valid in any cue,
/// after one of the reductions. If there are more than a model keeps (kMaxHeldOutFrames), the same
/// fraction of each place is drawn with `seed`.
HeldOutFrames keptFrames(const CalibrationSet& calibration_set, std::size_t reduction,
                         std::uint64_t seed);

}  // namespace place_recognition
