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
  int recording = 0;
  double stamp = 0;  ///< s
  int camera = 0;    ///< index into FrameCollection::cameras
  std::string name;
  int level = 0;  ///< see HalvingSample
  ExtractedFeatures extracted;
  ExtractedFeatures changed;  ///< of the changed image, if that is asked for

  bool hasFeature() const { return extracted.problem.empty(); }
  bool hasChangedFeature() const { return !changed.features.empty() && changed.problem.empty(); }
};

/// The label of any frame, used or not.
struct SeenLabel {
  double stamp = 0;   ///< s
  std::string place;  ///< empty: unlabelled
};

/// What was read from recordings.
struct FrameCollection {
  std::vector<std::string> inputs;           ///< names of the recordings
  std::vector<std::string> cameras;          ///< topics, of all recordings
  std::vector<std::vector<SeenLabel>> seen;  ///< [recording]
  std::vector<LeftOutFrames> left_out;       ///< [recording]
  std::vector<std::string> warnings;
  std::deque<CollectedFrame> frames;  ///< they stay where they are while threads fill them
  std::uint64_t images = 0;           ///< all that were read
  std::uint64_t passed_over = 0;      ///< by sampling.rate
  ImageProfile profile;               ///< of the images that count, and the one expected
  HalvingSample sample;               ///< by which `frames` were kept from growing
};

/// Reads the recordings and extracts the features of their labelled frames, of which it holds at
/// most about twice `most`. `profile`: what images are brought to and held against. `model`: the
/// one to learn on from, against whose light that of a recording is held; null: none. `change`: an
/// image that is learned beside each, if any. Throws Error if a recording is damaged or a label
/// cannot name a place.
FrameCollection collectFrames(const std::vector<RecordingOpener>& recordings,
                              const TrainingOptions& options, const ImageProfile& profile,
                              const Model* model, const ImageChange& change, std::size_t most,
                              unsigned threads, const Progress& progress);

}  // namespace place_recognition
