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

/// An image as it might look another time.
struct ChangedImage {
  cv::Mat image;
  Light correction;  ///< what cues that follow the light of the recording multiply it by
};
using ImageChange = std::function<ChangedImage(const cv::Mat& image, const std::string& place)>;

/// Frames that judged a model before.
struct JudgedBefore {
  HeldOutFrames frames;
  std::vector<int> place_of;  ///< for each place of that model, its index in `places`
};

/// What training keeps of the labelled frames of its runs: first those as they were recorded, in
/// the order of the recordings, then the same frames changed, if that is asked for.
struct Samples {
  std::vector<std::string> places;             ///< names, ascending
  std::vector<SampleOrigin> origins;           ///< one per sample; place: index into `places`
  std::vector<std::vector<Feature>> features;  ///< [cue][sample]; some may be missing
  std::vector<int> source;                     ///< of each sample: the recorded one that it shows
  std::size_t recorded = 0;                    ///< how many show the light of the recording
  std::size_t remembered = 0;          ///< the first of these, from models, not from these runs
  std::vector<std::uint64_t> images;   ///< of each place, that it was learned from in all
  std::vector<ColourMoments> colours;  ///< of each place, of the recorded images
  std::vector<std::string> inputs;     ///< names of the recordings
  std::vector<std::string> cameras;    ///< of `origins`, by topics; of several recordings together
  ImageProfile image_profile;          ///< of `profile`'s images and those learned from
  Adjacency adjacency{0};              ///< of `places`, from the recordings that are drives
  std::uint64_t skipped = 0;           ///< frames without label, image or any feature
  std::uint64_t passed_over = 0;       ///< usable ones, see SamplingOptions
  std::vector<JudgedBefore> judged_before;  ///< of the models that the remembered ones are from
  std::vector<std::string> warnings;        ///< what was skipped and why, a sentence per run

  std::vector<SampleOrigin> recordedOrigins() const {
    return {origins.begin(), origins.begin() + static_cast<std::ptrdiff_t>(recorded)};
  }
};

/// Reads the runs one after the other in this thread and extracts features in `threads` others (0:
/// one per core); a few frames at most wait in between. Throws Error if there is no image, no
/// label, a label that cannot name a place, or if fewer than `least_places` have samples; Cancelled
/// if `progress` asks for it. Images are brought to the size of `profile`; without one to
/// commonSize(runs). Each image is there a second time as `change` makes it, or, if there is
/// none, in other light if `options` say so.
Samples collectSamples(const std::vector<RecordingOpener>& recordings,
                       const TrainingOptions& options, unsigned threads, const Progress& progress,
                       std::size_t least_places = 2,
                       const std::optional<ImageProfile>& profile = {},
                       const ImageChange& change = {});

/// The same for a model that learns on or is to be judged: images are brought to the size of those
/// it was trained on, and cues that follow the light of a recording see them in the light of its
/// training, as far as their labels tell it.
Samples collectSamplesFor(const Model& model, const std::vector<RecordingOpener>& recordings,
                          const TrainingOptions& options, unsigned threads,
                          const Progress& progress, std::size_t least_places);

}  // namespace place_recognition
