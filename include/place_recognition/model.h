#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "place_recognition/adjacency.h"
#include "place_recognition/calibration.h"
#include "place_recognition/camera_correlation.h"
#include "place_recognition/classifier.h"
#include "place_recognition/colour_statistics.h"
#include "place_recognition/depth_extent.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// Where a model came from.
struct Provenance {
  std::vector<std::string> inputs;          ///< runs trained on, as named by the user
  std::vector<std::uint64_t> place_images;  ///< training images of each place
  std::uint64_t skipped_images = 0;         ///< unlabelled, unreadable or without any feature
  std::string package_version;
};

/// Quality on held-out blocks of the training runs.
struct Validation {
  double average_rate = 0;       ///< 0..1, mean of the rooms' rates
  double calibration_error = 0;  ///< expected calibration error, 0..1
};

/// The images that a model was trained on, as far as those that it is shown should be like them.
struct ImageProfile {
  int width = 0;         ///< pixels, as recorded; 0: not known, as in models of older versions
  int height = 0;        ///< likewise
  bool colour = false;   ///< some of them show colours
  double darkest = 255;  ///< mean brightness of the darkest one, 0..255
  double brightest = 0;  ///< of the brightest one
  DepthExtent depth;     ///< of those of 16 bits

  bool known() const { return width > 0; }
};

/// A model keeps this many held-out frames at most.
constexpr std::size_t kMaxHeldOutFrames = 1000;

/// Held-out answers that judged a model: kept so that old and new ones count together when it
/// learns on.
struct HeldOutFrames {
  std::vector<int> places;                       ///< what each frame shows
  std::vector<int> folds;                        ///< frames of one fold were held out together
  std::vector<Eigen::MatrixXf> decision_values;  ///< [cue]: frames x places
  std::vector<Eigen::VectorXf> familiarity;      ///< [cue]: of each frame; NaN: it lacks the cue
};

/// Everything needed to recognize, and where it came from. Immutable once trained or loaded; shared
/// between threads as std::shared_ptr<const Model>.
struct Model {
  std::string name;                     ///< set by whoever loads or saves it; not in the file
  std::string version;                  ///< 8 hex digits of the file's checksum; set likewise
  TrainingOptions asked;                ///< as given
  TrainingOptions options;              ///< as used: gamma, reduction, blocks of time as found
  ImageProfile images;                  ///< that it was trained on
  std::vector<std::string> places;      ///< names, in ascending order; at least two
  std::vector<Classifier> classifiers;  ///< one per cue of `options`
  std::vector<double> cue_weights;      ///< one per cue, of the sum of decision values
  Calibration calibration;              ///< of the summed decision values
  double unknown_threshold = 0;         ///< see Recognition::known
  Validation validation;
  HeldOutFrames held_out;     ///< what the three above rest on; empty in files of earlier versions
  ColourStatistics colours;   ///< of the images that it was trained on
  Adjacency adjacency{0};     ///< of `places`; learned from the recordings that are drives
  CameraCorrelation cameras;  ///< that it was trained with, if they are several
  Provenance provenance;

  /// Names of the places that held-out frames showed: the ones that the validation speaks of.
  std::vector<std::string> validatedPlaces() const;
  /// Over all cues.
  std::size_t supportVectorCount() const;
};

}  // namespace place_recognition
