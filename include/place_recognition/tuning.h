#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "place_recognition/progress.h"
#include "place_recognition/training.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// Where tune() looks; read from YAML.
struct SearchSpace {
  std::vector<std::vector<std::string>> descriptors = {
      {"Lxx", "Lxy", "Lyy"}, {"Lx", "Ly"},
      {"grad(L)", "lap(L)"}, {"L"},
      {"R", "G", "B"},       {"L", "C1", "C2"},
      {"C1", "C2"},          {"Rx", "Ry", "Gx", "Gy", "Bx", "By"}};
  std::vector<std::vector<double>> scales = {{1}, {4}, {1, 4}, {2, 8}};
  std::vector<int> bins = {10, 16, 28};
  int max_dimensions = 6;
  std::vector<double> c = {10, 100, 1000};
  int max_cues = 6;
  bool other_light = true;
  int first_pictures = 200;
  int max_pictures = 1000;

  /// Further cues in question. Not read from YAML.
  std::vector<CueOptions> cues = {};

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor(
        "descriptors", self.descriptors,
        "sets of CRFH descriptors; the best scales and bins of each set become one candidate cue");
    visitor("scales", self.scales, "sets of scales t = sigma^2, pixels^2");
    visitor("bins", self.bins, "quantization levels of each dimension");
    visitor("max_dimensions", self.max_dimensions,
            "most dimensions of a histogram, descriptors times scales");
    visitor("c", self.c, "SVM penalty parameter C");
    visitor("max_cues", self.max_cues, "most cues that are combined, 1..8");
    visitor("other_light", self.other_light,
            "also change the light of the held-out images that are scored a second time; set to "
            "false if the rooms are only ever seen in the light of the runs");
    visitor("first_pictures", self.first_pictures,
            "approximate number of images for the first of at most two rounds, which compare "
            "scales and bins; the second round uses twice as many");
    visitor("max_pictures", self.max_pictures,
            "approximate number of images for choosing cues and C, and upper limit for the rounds");
  }
  /// Throws Error naming the first field out of range.
  void check() const;
};

/// How one configuration fared on held-out images.
struct TuningTrial {
  std::string stage;             ///< in plain words, as "round 1 of 2", "one more", "C"
  std::vector<CueOptions> cues;  ///< combined with the weights of their options
  double c = 0;                  ///< SVM penalty parameter C
  std::uint64_t images = 0;      ///< looked at
  double log_loss = 0;           ///< nats an image, rooms weighted alike; the criterion
  double rate = 0;               ///< mean of the rooms' rates on images as recorded
  double changed_rate = 0;       ///< the same on changed ones
};

/// What tune() found.
struct Tuning {
  TrainingOptions options;          ///< what `train` is to be given
  TuningTrial best;                 ///< how they fared
  std::vector<TuningTrial> trials;  ///< everything that was tried, in order
  bool complete = true;             ///< false: stopped early, and the best so far
  std::uint64_t images = 0;         ///< labelled ones in the recordings
  double seconds = 0;
};

/// Finds features and C for `recordings` by cross-validation within them, starting from `base`,
/// which also gives everything else. `base` is left only for good reason: it was found on other
/// sites, and a few hundred images of one recording cannot tell much.
///
/// Folds are whole runs if two or more of them hold every place, else the blocks of time that
/// training holds out; if `hold_out` is not empty, one split: trained on `recordings`, tested on
/// `hold_out`. A tested image is judged as it was recorded and as the next run might show it: in
/// other light, nearer, to the side, less sharp. The criterion is the log loss of the calibrated
/// probabilities: it uses how sure the answers are, where a rate of a few hundred frames only
/// knows right and wrong.
///
/// 1. For each set of descriptors, scales and bins by successive halving: a second round on
///    twice as many images for the best quarter of the first. What is simpler wins if it is
///    within one standard error (of the paired difference).
/// 2. From the cues of `base`, the step that gains most, while it gains four standard errors: a
///    survivor or a cue of `space.cues` in place of a cue, one more, or one less.
/// 3. C.
///    Measures between images are computed once a candidate and serve every C and combination.
///
/// Throws Error if the runs cannot be learned from, or a network cannot be used. If `progress` asks
/// for a stop, what was found by then is returned, at first `base`; Cancelled if it does so before
/// the images are counted. Independent of `threads`.
Tuning tune(const std::vector<RecordingOpener>& recordings,
            const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
            const SearchSpace& space, unsigned threads = 0, const Progress& progress = {});

}  // namespace place_recognition
