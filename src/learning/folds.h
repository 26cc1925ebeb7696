#pragma once

#include <vector>

namespace place_recognition {

/// Place and time of a training sample.
struct SampleOrigin {
  int place = 0;      ///< label
  int recording = 0;  ///< number of the recording; the parts of a split one share it
  double stamp = 0;   ///< s; only differences within a run count
  int camera = 0;     ///< if several cameras record the run together
  int age = 0;        ///< how many times its place has been learned again since
  int skipped = 0;  ///< frames of its place and camera since the previous sample that are not used
  int part = 0;     ///< number of the recording as given, where parts count separately
};

/// The number of recordings, which are numbered from 0: one more than the largest number.
int recordingCount(const std::vector<SampleOrigin>& samples);

/// Division of a run for cross-validation.
struct TimeBlocks {
  double length = 1;  ///< s; rounded up to whole samples
  double gap = 0;     ///< s; samples closer than this to a tested one are not trained on
};

/// The largest gap beside blocks of that length, in s, that leaves two fifths of a recording for
/// training: of its `folds` blocks, one block and two gaps are left out.
double largestGap(double length, int folds);

/// One split of samples for cross-validation: indices into the list of origins.
struct Fold {
  std::vector<int> train;
  std::vector<int> test;
};

/// The samples of one place in one recording.
struct Sequence {
  int recording = 0;
  int cameras = 1;            ///< number of cameras they come from
  std::vector<int> samples;   ///< in order of time
  std::vector<double> times;  ///< of each, s; one second apart if all have the same stamp
  bool stamped = false;       ///< the stamps differ
};

/// In order of recording, then of place.
std::vector<Sequence> sequencesOf(const std::vector<SampleOrigin>& samples);

/// The same with separate sequences for each camera, in order of recording, place and camera.
std::vector<Sequence> cameraSequencesOf(const std::vector<SampleOrigin>& samples);

/// Number of runs that contain every place of `samples`.
int completeRecordings(const std::vector<SampleOrigin>& samples);

/// Splits samples into `count` folds by contiguous blocks of time, never by random frames. Each
/// sequence, with all its cameras together, is cut into equal blocks of about `blocks[run].length`,
/// but into at least `count`; the folds test the blocks in turn. Samples of the recording that lie
/// within the gap of a tested one are not trained on in that fold, whatever their place: a frame in
/// front of a door would otherwise find the frames behind it, but none of its own room. The gap is
/// at most largestGap() of the actual blocks of the sequence. If at least `count` runs are
/// complete, see completeRecordings(), whole runs are the blocks instead.
std::vector<Fold> timeBlockFolds(const std::vector<SampleOrigin>& samples, int count,
                                 const std::vector<TimeBlocks>& blocks);

/// The same with the longest blocks: each sequence is cut into `count`. `gap`: s.
std::vector<Fold> longestBlockFolds(const std::vector<SampleOrigin>& samples, int count,
                                    double gap);

/// The fold that tests each of `samples`; -1 for those that none tests.
std::vector<int> testingFolds(const std::vector<Fold>& folds, std::size_t samples);

/// Extends `folds` of the original samples to samples that are followed by copies (`source`: index
/// of the original of each sample; its own index for an original). A tested sample is tested in
/// every copy. A training sample is trained on in every copy if `train_on_copies`.
std::vector<Fold> withCopies(std::vector<Fold> folds, const std::vector<int>& source,
                             bool train_on_copies);

}  // namespace place_recognition
