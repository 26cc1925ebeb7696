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
#include "place_recognition/level_range.h"
#include "place_recognition/run_sketch.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// Where a model came from.
struct Provenance {
  std::vector<std::string> inputs;          ///< runs trained on, as named by the user
  std::vector<std::uint64_t> place_images;  ///< training images of each place
  std::uint64_t skipped_images = 0;         ///< unlabelled, unreadable, or without any feature
  std::string package_version;
  std::vector<RunSketch> sketches;  ///< of each input; empty in files of earlier versions
};

/// Quality on held-out blocks of the training runs; zeros if it was not validated.
struct Validation {
  double average_rate = 0;       ///< 0..1, mean of the rooms' rates
  double calibration_error = 0;  ///< expected calibration error, 0..1
};

/// Properties of the training images that the images to be recognized should share.
struct ImageProfile {
  int width = 0;         ///< pixels, as recorded; 0: unknown, as in models of older versions
  int height = 0;        ///< likewise
  bool colour = false;   ///< some images are in colour
  double darkest = 255;  ///< mean brightness of the darkest image, 0..255
  double brightest = 0;  ///< mean brightness of the brightest image
  LevelRange levels;     ///< of images with 16 bits per channel

  bool known() const { return width > 0; }
  bool includesImages() const { return darkest <= brightest; }  ///< else only the size is known
};

/// Maximum number of held-out frames that a model keeps.
constexpr std::size_t kMaxHeldOutFrames = 1000;

/// Answers to the held-out frames on which a model was validated. They are kept so that old and new
/// frames count together in incremental training.
struct HeldOutFrames {
  std::vector<int> places;                       ///< true place of each frame
  std::vector<int> folds;                        ///< frames of one fold were held out together
  std::vector<Eigen::MatrixXf> decision_values;  ///< [cue]: frames x places
  std::vector<Eigen::VectorXf> familiarity;  ///< [cue]: of each frame; NaN: the frame lacks the cue
};

/// Everything needed to recognize, and its origin. Immutable once trained or loaded; shared between
/// threads as std::shared_ptr<const Model>.
struct Model {
  std::string name;                     ///< set when loading or saving; not in the file
  std::string version;                  ///< 8 hex digits of the file's checksum; set likewise
  TrainingOptions asked;                ///< as requested
  TrainingOptions options;              ///< as used: gamma, reduction and blocks of time as found
  ImageProfile images;                  ///< of the training images
  std::vector<std::string> places;      ///< names, in ascending order; at least two
  std::vector<Classifier> classifiers;  ///< one per cue of `options`
  std::vector<double> cue_weights;      ///< one per cue, in the mean of decision values
  /// Each decision value f of a cue counts as limit tanh(f / limit) in the mean that names the
  /// place, so that a cue far beyond the targets of an SVM, +1 and -1, cannot outvote the others.
  /// 0: no limit, for a single cue and in files of earlier versions.
  double decision_limit = 0;
  Calibration calibration;       ///< of the mean decision values
  double unknown_threshold = 0;  ///< see Recognition::known
  Validation validation;
  HeldOutFrames held_out;     ///< basis of the three above; empty in files of earlier versions
  ColourStatistics colours;   ///< of the training images
  Adjacency adjacency{0};     ///< of `places`; learned from recordings that are drives
  CameraCorrelation cameras;  ///< of the training, if there are several
  Provenance provenance;

  /// Names of the places in the held-out frames, that is, those covered by the validation.
  std::vector<std::string> validatedPlaces() const;
  /// Over all cues.
  std::size_t supportVectorCount() const;
};

}  // namespace place_recognition
