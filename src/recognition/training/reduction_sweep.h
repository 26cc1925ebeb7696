#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "recognition/training/model_reduction.h"

namespace place_recognition {

/// One reduction method with any number of vectors per cue, from one to all, measured on validation
/// samples.
class ReductionSweep {
 public:
  /// `options`: method and normalization. `rate` must outlive this.
  ReductionSweep(const Model& model, const ModelReduction& reduction, const RateOnSamples& rate,
                 ReductionOptions options, const Progress& progress);

  double rate(int vectors) const;

  /// The fewest vectors that reach the rate `wanted`; all if no number does. The rate need not
  /// increase monotonically, so the search starts at one vector and proceeds in steps that grow to
  /// a fiftieth.
  int fewest(double wanted, const Progress& progress) const;

  /// Points (fraction of the vectors, rate), ascending up to all vectors.
  std::vector<std::pair<double, double>> curve() const;

 private:
  const RateOnSamples& rate_;
  int most_;  // vectors of the cue with the most
  std::vector<std::unique_ptr<const Reduction>> reductions_;
};

}  // namespace place_recognition
