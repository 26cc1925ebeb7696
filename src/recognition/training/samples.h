#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/adjacency.h"
#include "place_recognition/feature.h"
#include "place_recognition/model.h"
#include "place_recognition/training.h"
#include "recognition/frames/colour_statistics.h"
#include "recognition/frames/light.h"

namespace place_recognition {

/// An image as it might look at another time.
struct ChangedImage {
  cv::Mat image;
  Light correction;  ///< gains of cues that follow the light of the recording
};
using ImageChange = std::function<ChangedImage(const cv::Mat& image, const std::string& place)>;

/// Frames on which an earlier model was validated.
struct JudgedBefore {
  HeldOutFrames frames;
  std::vector<int> place_of;  ///< for each place of that model, its index in `places`
};

/// The data that training keeps of the labelled frames of its runs: first the frames as recorded,
/// in the order of the recordings, then the same frames changed, if requested.
struct Samples {
  std::vector<std::string> places;             ///< names, ascending
  std::vector<SampleOrigin> origins;           ///< one per sample; place: index into `places`
  std::vector<std::vector<Feature>> features;  ///< [cue][sample]; some may be missing
  std::vector<int> source;     ///< by sample: the recorded sample that it is a version of
  std::size_t recorded = 0;    ///< number of samples in the light of the recording
  std::size_t remembered = 0;  ///< the first of these, which come from models, not recordings
  std::vector<std::uint64_t> images;        ///< by place: number of images learned in total
  std::vector<ColourMoments> colours;       ///< by place, of the recorded images
  std::vector<std::string> inputs;          ///< names of the recordings
  std::vector<RunSketch> sketches;          ///< of each input
  std::vector<std::string> cameras;         ///< of `origins`, by topics; over all recordings
  ImageProfile image_profile;               ///< of the images learned
  Adjacency adjacency{0};                   ///< of `places`, from the recordings that are drives
  std::uint64_t skipped = 0;                ///< frames without label, image or feature
  std::uint64_t passed_over = 0;            ///< usable ones, see SamplingOptions
  std::vector<JudgedBefore> judged_before;  ///< of the models of the remembered samples
  std::vector<std::string> warnings;        ///< what was skipped and why, one sentence per run

  std::vector<SampleOrigin> recordedOrigins() const {
    return {origins.begin(), origins.begin() + static_cast<std::ptrdiff_t>(recorded)};
  }
};

/// Reads the recordings one after another in this thread and extracts features in `threads` others
/// (0: one per core); at most a few frames wait in between. Throws Error if there is no image, no
/// label, a label that cannot name a place, or if fewer than `least_places` places have samples;
/// Cancelled if `progress` requests it. Images are scaled to the size of `profile`; without one, to
/// commonSize(). Each image is included a second time, as changed by `change` or, if that is not
/// set, in other light if `options` request it.
Samples collectSamples(const std::vector<RecordingOpener>& recordings,
                       const TrainingOptions& options, unsigned threads, const Progress& progress,
                       std::size_t least_places = 2,
                       const std::optional<ImageProfile>& profile = {},
                       const ImageChange& change = {});

/// The same for a model that learns incrementally or is validated: images are scaled to the size of
/// its training images, and cues that follow the light of a recording see them in the light of its
/// training, as far as their labels determine it.
Samples collectSamplesFor(const Model& model, const std::vector<RecordingOpener>& recordings,
                          const TrainingOptions& options, unsigned threads,
                          const Progress& progress, std::size_t least_places);

}  // namespace place_recognition
