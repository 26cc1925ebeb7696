#pragma once

#include <vector>

#include "learning/folds.h"
#include "place_recognition/feature.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// How the similarity of frames in a recording decreases with time, averaged over rooms and cues.
/// Distances are those of the kernels, in units of the mean distance between two frames of a room.
struct LikenessOverTime {
  double step = 0;                ///< s, median time from one frame of a room to the next
  std::vector<double> distances;  ///< [lag - 1]: mean between frames `lag` frames apart
  double next_is_nearest = 0;     ///< fraction of frames most similar to the one before or after,
                                  ///< among those of which one of these two is used
};

/// Chooses the gap, in s, so that held-out frames resemble those of the next run through the same
/// rooms: nearly the same views, but no frame twice. The gap ends half a frame before the first lag
/// at which the distance has grown by an eighth of the way from lag 0 (extrapolated, since noise
/// alone makes it positive) to the mean distance of the room. If the next frame in time is often
/// the most similar (for more than a third of the frames; by chance this is rare), the gap includes
/// at least that frame.
double gapFor(const LikenessOverTime& likeness);

/// The similarity of about a hundred frames of `recording` to all others of their rooms. Lags count
/// frames that were thinned out, too: how fast the view changes does not depend on how many of its
/// frames are used. `features`: [cue][sample]; some may be missing.
LikenessOverTime likenessOverTime(const std::vector<SampleOrigin>& samples, int recording,
                                  const std::vector<std::vector<Feature>>& features,
                                  const std::vector<CueOptions>& cues, unsigned threads);

/// The blocks of each recording: as `options` specify, or derived from its samples. Unless
/// specified, blocks are as long as the gap, or longer if the folds would leave less than two
/// fifths for training.
std::vector<TimeBlocks> chooseBlocks(const std::vector<SampleOrigin>& samples,
                                     const std::vector<std::vector<Feature>>& features,
                                     const std::vector<CueOptions>& cues,
                                     const ValidationOptions& options, unsigned threads);

}  // namespace place_recognition
