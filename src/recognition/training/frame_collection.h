#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "place_recognition/progress.h"
#include "place_recognition/training.h"
#include "recognition/frames/extraction_pool.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/left_out_frames.h"
#include "recognition/training/halving_sample.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// A labelled frame that can be learned.
struct CollectedFrame {
  std::string place;
  int recording = 0;  ///< index into FrameCollection::seen
  int part = 0;       ///< index into FrameCollection::inputs
  double stamp = 0;   ///< s
  int camera = 0;     ///< index into FrameCollection::cameras
  int number = 0;     ///< among all frames of its place by its camera in the recording
  std::string name;
  int level = 0;  ///< see HalvingSample
  ExtractedFeatures extracted;
  ExtractedFeatures changed;  ///< of the changed image, if requested

  bool hasFeature() const { return extracted.problem.empty(); }
  bool hasChangedFeature() const { return !changed.features.empty() && changed.problem.empty(); }
};

/// The label of a frame, whether it is used or not.
struct SeenLabel {
  double stamp = 0;   ///< s
  std::string place;  ///< empty: unlabelled
};

/// Everything read from recordings.
struct FrameCollection {
  /// `expected`: properties of the images; `seed`: of the sample.
  FrameCollection(const ImageProfile& expected, std::uint64_t seed)
      : profile(expected), sample(seed) {}

  std::vector<std::string> inputs;           ///< names of the recordings
  std::vector<RunSketch> sketches;           ///< of each input
  std::vector<std::string> cameras;          ///< topics, of all recordings
  std::vector<std::vector<SeenLabel>> seen;  ///< [recording]; parts of a split one are joined
  std::vector<LeftOutFrames> left_out;       ///< of each input
  std::vector<std::string> warnings;
  std::deque<CollectedFrame> frames;  ///< stay in place while threads fill them
  std::uint64_t images = 0;           ///< number of all images read
  std::uint64_t passed_over = 0;      ///< by sampling.rate
  ImageProfile profile;               ///< of the images in use and the expected one
  HalvingSample sample;               ///< the sample to which `frames` is limited
  std::string how_to_label;           ///< Recording::howToLabel() of the first one
};

/// Reads the recordings and extracts the features of their labelled frames, and keeps at most about
/// twice `most` of them. A recording that continues the one before (see Continuity) is a part of
/// it. `profile`: the size to which images are scaled, and their expected properties. `model`: the
/// model of incremental training, to whose light that of a recording is compared; null if none.
/// `change`: makes an additional image from each, if set. Throws Error if a recording is damaged or
/// a label cannot name a place.
FrameCollection collectFrames(const std::vector<RecordingOpener>& recordings,
                              const TrainingOptions& options, const ImageProfile& profile,
                              const Model* model, const ImageChange& change, std::size_t most,
                              unsigned threads, const Progress& progress);

}  // namespace place_recognition
