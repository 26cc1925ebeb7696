#pragma once

#include <Eigen/Core>
#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/cross_validation.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// How all images compare by one cue: measures of the kernel, computed once, which serve every
/// C and combination. A gamma that is open is one over twice the typical distance; training finds
/// its own.
class CueComparison {
 public:
  /// Compares `features` of all `samples`, which must outlive this.
  CueComparison(CueOptions cue, std::vector<Feature> features, const TuningSamples& samples,
                unsigned threads);

  /// The cue as it was given.
  const CueOptions& cue() const { return cue_; }

  /// Held-out decision values, samples x places. Zero where the cue is missing.
  HeldOutValues heldOut(const SvmOptions& svm, unsigned threads) const;

 private:
  CueOptions cue_;
  KernelOptions kernel_;  // with the gamma that it is compared at
  const TuningSamples& samples_;
  std::vector<int> rows_;     // of each sample in measures_; -1: it lacks the cue
  Eigen::MatrixXd measures_;  // all samples that have the cue x recorded ones that have it
};

}  // namespace place_recognition
