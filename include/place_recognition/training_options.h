#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "place_recognition/feature_options.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// Conversion of the image of an omnidirectional camera, which looks into a mirror, to a panorama:
/// the ring that shows the mirror is unrolled with its rim at the top (thesis section 2.3.1).
struct PanoramaOptions {
  std::string mirror = "none";
  double center_x = 0.5;
  double center_y = 0.5;
  double inner = 0.12;
  double outer = 0.47;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(
        "mirror", self.mirror,
        "mirror of an omnidirectional camera. none: an ordinary camera; given: the next four keys "
        "state the position of the ring; found: they are found in the first images of the runs");
    visitor("center_x", self.center_x, "centre of the ring, in fractions of the image's width");
    visitor("center_y", self.center_y, "centre of the ring, in fractions of the image's height");
    visitor("inner", self.inner,
            "radius within which the mirror shows the camera itself, in fractions of the image's "
            "shorter side");
    visitor("outer", self.outer,
            "radius of the mirror's rim, in fractions of the image's shorter side");
  }
  void check() const;
};

/// Preparation of an image before features are extracted.
struct ImageOptions {
  int max_width = 640;
  PanoramaOptions panorama;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("max_width", self.max_width,
            "pixels; wider images are scaled down to it; 0: never. Recognition scales images to "
            "the size of the training images");
    visitor("panorama", self.panorama, "omnidirectional cameras");
  }
  void check() const;
};

/// Selection of the images to learn. Neighbouring images are nearly copies of one another, and
/// memory grows with the square of their number.
struct SamplingOptions {
  double rate = 0;
  int most = 10000;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("rate", self.rate, "most images per second of a run to learn, by their stamps; 0: all");
    visitor(
        "most", self.most,
        "most images to learn, including those in other light, 10 or more; if there are more, the "
        "same fraction of each room is drawn at random; memory is 16 bytes times the square");
  }
  void check() const;
};

/// Treatment of images with little information, such as those of a wall that fills the view (thesis
/// section 3.5). Information is measured by edge density: the fraction of pixels whose gradient at
/// sigma = 1 exceeds 4 grey levels per pixel.
struct InformationOptions {
  double left_out_below = 0;
  double unknown_below = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(
        "left_out_below", self.left_out_below,
        "edge density, 0 to less than 1, below which an image is not learned; 0: all are. It is "
        "the fraction of pixels that differ from their neighbours by more than 4 grey levels: "
        "less than 0.02 for a bare wall, less than 0.05 for one with part of a poster on it");
    visitor("unknown_below", self.unknown_below,
            "edge density, 0 to less than 1, below which an image is answered 'unknown', whatever "
            "its room; 0: "
            "never");
  }
  void check() const;
};

/// One cue: a feature, the kernel that compares it, and its weight among other cues.
struct CueOptions {
  std::string name = "crfh";
  std::string normalize = "none";
  double weight = 1;
  FeatureOptions feature;
  KernelOptions kernel;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("name", self.name,
            "name of the cue, for use in keys such as --set cues.NAME.kernel.gamma=10");
    visitor("normalize", self.normalize,
            "normalization of an image's colours. none; brightness: one gain brings its mean level "
            "to 110; grey-world: one gain per channel does; run: one gain per channel brings the "
            "light of the run, as far as it is known, to that of the training, and the weight of "
            "the cue grows with the certainty of the light");
    visitor("weight", self.weight,
            "weight of the cue relative to the others, 0.01..100, unless held-out frames clearly "
            "favour other weights");
    visitor("feature", self.feature, "the feature extracted from each image");
    visitor("kernel", self.kernel, "the comparison of two such features");
  }
};

/// The cues that `train` uses by default: two of colour and two of edges, of which one works as
/// long as the light stays the same and the other in changed light, and the directions of edges at
/// each height (doc/choices.md).
std::vector<CueOptions> defaultCues();

/// Additional training images, derived from those of the recordings.
struct AugmentationOptions {
  bool other_light = false;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("other_light", self.other_light,
            "learn each image a second time as it would look in other light, drawn at random: "
            "darker, brighter, warmer or colder");
  }
};

/// Cross-validation within the training runs: for gamma, the probabilities, and `unknown`.
struct ValidationOptions {
  static constexpr int kMaxFolds = 10000;
  int folds = 5;
  double block = 0;
  double gap = 0;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("folds", self.folds,
            "number of trainings, each without some blocks of time of the runs, 2..10000; if it is "
            "the number of images, validation is leave-one-out, for small sets");
    visitor("block", self.block,
            "s, length of the blocks that are held out in turn; at most 1 / folds of a room; "
            "images of a folder count as one second apart; 0: as long as the gap");
    visitor("gap", self.gap,
            "s, time on each side of a held-out block that is also left out of training; 0: "
            "derived from how fast the frames of the run cease to be alike");
  }
  void check() const;
};

/// When to answer `unknown`.
struct UnknownOptions {
  double false_alarm_rate = 0.05;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("false_alarm_rate", self.false_alarm_rate,
            "fraction of held-out frames of known rooms that may be answered 'unknown', 0..1");
  }
  void check() const;
};

/// All options of `train`; read from YAML (config/), stored in the model.
struct TrainingOptions {
  ImageOptions image;
  SamplingOptions sampling;
  InformationOptions information;
  AugmentationOptions augmentation;
  std::vector<CueOptions> cues = defaultCues();
  SvmOptions svm;
  ReductionOptions reduction;
  ValidationOptions validation;
  UnknownOptions unknown;
  std::uint64_t seed = 1;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("image", self.image, "preparation of the image");
    visitor("sampling", self.sampling, "selection of the images to learn");
    visitor("information", self.information, "images with little information");
    visitor("augmentation", self.augmentation, "additional images derived from those of the runs");
    visitor("cues", self.cues, "one or more cues; their decision values are combined");
    visitor("svm", self.svm, "the support vector machines");
    visitor("reduction", self.reduction, "support vector reduction");
    visitor("validation", self.validation, "cross-validation within the training runs");
    visitor("unknown", self.unknown, "when to answer 'unknown'");
    visitor("seed", self.seed,
            "seed of all random choices: the learned images if there are too many, the images that "
            "gamma and `tune` use, and the light of each image with augmentation.other_light");
  }
  /// Throws Error naming the first field out of range.
  void check() const;
};

}  // namespace place_recognition
