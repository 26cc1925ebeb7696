#pragma once

#include <Eigen/Core>
#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/held_out_values.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// The kernel measures of all images by one cue, computed once for every C and combination. A gamma
/// that is not given is one over twice the typical distance; training later finds its own.
class CueComparison {
 public:
  /// Compares `features` of all `samples`, which must outlive this.
  CueComparison(CueOptions cue, std::vector<Feature> features, const TuningSamples& samples,
                unsigned threads);

  /// The cue as given.
  const CueOptions& cue() const { return cue_; }

  /// Held-out decision values, samples x places. Zero where the cue is missing.
  HeldOutValues heldOut(const SvmOptions& svm, unsigned threads) const;

 private:
  CueOptions cue_;
  KernelOptions kernel_;  // with the gamma of the comparison
  const TuningSamples& samples_;
  std::vector<int> rows_;     // row of each sample in measures_; -1: it lacks the cue
  Eigen::MatrixXd measures_;  // samples with the cue x recorded samples with the cue
};

}  // namespace place_recognition
