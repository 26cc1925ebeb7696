#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "place_recognition/part.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// The configurations that tune() searches; read from YAML.
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

  /// Additional candidate cues. Not read from YAML.
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
    visitor("max_cues", self.max_cues,
            "most cues that are combined, 1..8, if the search does not start from more");
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

/// Scores of one configuration on held-out images.
struct TuningTrial {
  std::string stage;             ///< in plain words, such as "round 1 of 2", "one more", "C"
  std::vector<CueOptions> cues;  ///< combined with the weights in their options
  double c = 0;                  ///< SVM penalty parameter C
  std::uint64_t images = 0;      ///< evaluated
  double log_loss = 0;           ///< nats per image, rooms weighted equally; the criterion
  double rate = 0;               ///< mean of the rooms' rates on unchanged images
  double changed_rate = 0;       ///< the same on changed images
};

/// Result of tune().
struct Tuning {
  TrainingOptions options;          ///< to pass to `train`
  TuningTrial best;                 ///< scores of these options
  std::vector<TuningTrial> trials;  ///< everything that was tried, in order
  bool complete = true;             ///< false: stopped early; the options are the best so far
  std::uint64_t images = 0;         ///< labelled images in the recordings
  double seconds = 0;
};

/// Finds features and C for `recordings` by cross-validation within them. The search starts from
/// `base`, which also provides all other options. It leaves `base` only for a clear gain: `base`
/// was found on other sites, and a few hundred images of one recording prove little.
///
/// Folds are whole runs if two or more of them contain every place, otherwise the blocks of time
/// that training holds out. If `hold_out` is not empty, there is one split: train on `recordings`,
/// test on `hold_out`. Each test image is scored unchanged and as the next run might show it: in
/// other light, nearer, shifted sideways, less sharp. The criterion is the log loss of the
/// calibrated probabilities, because it takes the certainty of the answers into account; the rate
/// of a few hundred frames only distinguishes right from wrong.
///
/// 1. For each set of descriptors, select scales and bins by successive halving: the best quarter
///    of the first round enters a second round on twice as many images. The simpler candidate wins
///    if it is within one standard error (of the paired difference).
/// 2. From the cues of `base`, repeatedly take the step with the largest gain, as long as the gain
///    exceeds four standard errors: replace a cue by a survivor or by a cue of `space.cues`, add
///    one, or remove one.
/// 3. Select C.
///
/// Measures between images are computed once per candidate and serve every C and combination.
///
/// Throws Error if the runs cannot be learned from, or a network cannot be used. If `progress`
/// requests a stop, the result so far is returned, initially `base`; Cancelled is thrown if the
/// images are not counted yet. The result does not depend on `threads`.
///
/// If `cells` names a folder, step 1 stores there what it finds out about each set in each round
/// and does not compute again what the folder already holds: an interrupted search continues where
/// it stopped. A cell is used only for the same frames and options.
Tuning tune(const std::vector<RecordingOpener>& recordings,
            const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
            const SearchSpace& space, unsigned threads = 0, const Progress& progress = {},
            const std::string& cells = {});

/// The outcome of a part of a search.
struct TuningPart {
  std::size_t cells = 0;
  std::size_t computed = 0;  ///< in this run; the others already existed
};

/// Computes the cells of `part` of the sets of descriptors, most of the work of tune(), and stores
/// them in the folder `cells`, for tune() with the same arguments. Parts may run at the same time,
/// on several machines that share the folder. Throws Error, Cancelled.
TuningPart tunePart(const std::vector<RecordingOpener>& recordings,
                    const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
                    const SearchSpace& space, const std::string& cells, const Part& part,
                    unsigned threads = 0, const Progress& progress = {});

}  // namespace place_recognition
