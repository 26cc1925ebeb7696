#pragma once

#include <vector>

namespace place_recognition {

/// Where and when a training sample was taken.
struct SampleOrigin {
  int place = 0;      ///< label
  int recording = 0;  ///< number of the recording
  double stamp = 0;   ///< s; only differences within a run count
  int camera = 0;     ///< of several that record a run together
  int age = 0;        ///< how many times its place has been learned again since
};

/// How a run is cut for cross-validation.
struct TimeBlocks {
  double length = 1;  ///< s; rounded up to whole samples
  double gap = 0;     ///< s; samples within it of a tested one are not trained on
};

/// The largest gap beside blocks of that length, in s, that leaves two fifths of a recording to
/// train on: of `folds` blocks, all but one and two gaps.
double largestGap(double length, int folds);

/// One split of samples for cross-validation: indices into the list of origins.
struct Fold {
  std::vector<int> train;
  std::vector<int> test;
};

/// The samples of one recording and place.
struct Sequence {
  int recording = 0;
  int cameras = 1;            ///< how many they are of
  std::vector<int> samples;   ///< in order of time
  std::vector<double> times;  ///< of each, s; a second apart if all have the same stamp
  bool stamped = false;       ///< they have not
};

/// In order of run, then of place.
std::vector<Sequence> sequencesOf(const std::vector<SampleOrigin>& samples);

/// The same, those of each camera apart, in order of run, place and camera.
std::vector<Sequence> cameraSequencesOf(const std::vector<SampleOrigin>& samples);

/// Median of the steps of ascending `times` that are not zero; 0 if there is none.
double medianStep(const std::vector<double>& times);

/// Whether there are `count` runs that hold every place.
bool wholeRecordings(const std::vector<SampleOrigin>& samples, int count);

/// Splits samples into `count` folds by contiguous blocks of time, never by random frames. Each
/// sequence, all of its cameras together, is cut into equal blocks of about `blocks[run].length`,
/// but into `count` of them at least, which are tested in the folds in turn. Samples of the
/// recording that lie within the gap of a tested one are not trained on in that fold, whatever
/// their place: a frame before a door would find the frames behind it, but none of its own room.
/// The gap is no larger than largestGap() of the blocks that the sequence was cut into. If
/// wholeRuns(), runs are the blocks instead.
std::vector<Fold> timeBlockFolds(const std::vector<SampleOrigin>& samples, int count,
                                 const std::vector<TimeBlocks>& blocks);

/// `folds` of the first samples, where later ones are copies of these (`source`: of each sample,
/// the one that it is a copy of, often itself): what is tested is tested in every copy, and what is
/// trained on is trained on in every copy if `train_on_copies`.
std::vector<Fold> withCopies(std::vector<Fold> folds, const std::vector<int>& source,
                             bool train_on_copies);

}  // namespace place_recognition
