#pragma once

#include <cstdint>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/model.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// Everything that judges a model: held-out decision values of the samples that it learns now and,
/// behind them, of frames that it was judged by before.
struct CalibrationSet {
  std::vector<SampleOrigin> samples;
  std::vector<Fold> folds;                             ///< only what is tested
  std::vector<std::vector<HeldOutValues>> reductions;  ///< [reduction][cue]

  /// Adds frames that an earlier training held out; `place_of`: the place of now for each of
  /// theirs. They have no decision value for a place that is new, and take the mean decision value
  /// of those of the first `remembered` samples that show their own place; -1 if there is none.
  void add(const HeldOutFrames& frames, const std::vector<int>& place_of, std::size_t remembered);
};

/// The frames of the judges that are valid in any cue, with one of the reductions; of more than
/// the model keeps (kMaxHeldOutFrames), the same fraction of each place, drawn by `seed`.
HeldOutFrames keptFrames(const CalibrationSet& calibration_set, std::size_t reduction,
                         std::uint64_t seed);

}  // namespace place_recognition
