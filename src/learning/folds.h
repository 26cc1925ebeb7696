#pragma once

#include <vector>

namespace place_recognition {

/// Where and when a training sample was taken.
struct SampleOrigin {
  int place = 0;     ///< label
  int run = 0;       ///< number of the recording
  double stamp = 0;  ///< s; only the order within a run and a place counts
};

/// One split of samples for cross-validation: indices into the list of origins.
struct Fold {
  std::vector<int> train;
  std::vector<int> test;
};

/// Splits samples into `count` folds by contiguous blocks of time, never by random frames, so that
/// no tested frame has a neighbour among the trained ones: within each run and place, samples in
/// order of stamp are cut into `count` blocks, block f is tested in fold f, and the `gap` samples
/// at each side of a tested block are trained on in no fold that tests that block.
/// With at least `count` runs that hold every place, whole runs are the blocks instead.
std::vector<Fold> timeBlockFolds(const std::vector<SampleOrigin>& samples, int count, int gap);

/// `folds` of the first samples, where later ones are copies of these (`source`: of each sample,
/// the one that it is a copy of, often itself): what is tested is tested in every copy, and what is
/// trained on is trained on in every copy if `train_on_copies`.
std::vector<Fold> withCopies(std::vector<Fold> folds, const std::vector<int>& source,
                             bool train_on_copies);

}  // namespace place_recognition
