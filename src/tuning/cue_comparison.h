#pragma once

#include <Eigen/Core>
#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/held_out.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// How all pictures compare by one cue: measures of the kernel, computed once, which serve every
/// gamma and C. A kernel whose measures depend on gamma is compared at one gamma only.
class CueComparison {
 public:
  /// Compares `features` of all `samples`, which must outlive this.
  CueComparison(CueOptions cue, std::vector<Feature> features, const TuningSamples& samples,
                unsigned threads);

  /// The gamma that stands to reason; 0 for a kernel without.
  double neutralGamma() const { return neutral_gamma_; }
  /// Whether other values of gamma can be tried.
  bool gammaIsFree() const { return gamma_is_free_; }
  /// The cue with that gamma.
  CueOptions withGamma(double gamma) const;

  /// Held-out margins, samples x places. Zero where the cue is missing.
  HeldOut heldOut(double gamma, const SvmOptions& svm, unsigned threads) const;

 private:
  CueOptions cue_;
  const TuningSamples& samples_;
  std::vector<int> rows_;     // of each sample in measures_; -1: it lacks the cue
  Eigen::MatrixXd measures_;  // all samples that have the cue x recorded ones that have it
  double neutral_gamma_ = 0;
  bool gamma_is_free_ = false;
};

}  // namespace place_recognition
