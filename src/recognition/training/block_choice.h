#pragma once

#include <vector>

#include "learning/folds.h"
#include "place_recognition/feature.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// How fast the frames of a recording cease to be alike, averaged over rooms and cues. Distances
/// are those of the kernels, in units of the mean distance between two frames of a room.
struct LikenessOverTime {
  double step = 0;                ///< s, median time from one frame of a room to the next
  std::vector<double> distances;  ///< [lag - 1]: mean between frames that are `lag` frames apart
  double next_is_nearest = 0;     ///< fraction of frames that are most like the one before or after
};

/// Chooses the gap, in s, for cross-validation as the next run through the same rooms would have
/// it: nearly the same views again, but no frame twice. The gap ends half a frame before the first
/// lag at which frames differ by an eighth of the way from none (the distance prolonged to lag 0,
/// which noise makes) to that of any two frames of the room; if most often the next frame in time
/// is the most alike (in more than a third of the frames: by chance it is rarely), at least that
/// one lies in the gap.
double gapFor(const LikenessOverTime& likeness);

/// The likeness of some hundred frames of `recording` to all others of their rooms. `features`:
/// [cue][sample], some missing.
LikenessOverTime likenessOverTime(const std::vector<SampleOrigin>& samples, int recording,
                                  const std::vector<std::vector<Feature>>& features,
                                  const std::vector<CueOptions>& cues, unsigned threads);

/// The blocks of each recording: as `options` say, or else as its samples have it. Blocks are as
/// long as the gap if not asked for, or longer if so few folds would leave less than two fifths to
/// train on.
std::vector<TimeBlocks> chooseBlocks(const std::vector<SampleOrigin>& samples,
                                     const std::vector<std::vector<Feature>>& features,
                                     const std::vector<CueOptions>& cues,
                                     const ValidationOptions& options, unsigned threads);

}  // namespace place_recognition
