#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "recognition/training/model_reduction.h"

namespace place_recognition {

/// One method of reduction with any number of vectors of each cue, from one to all, measured on
/// validation samples.
class ReductionSweep {
 public:
  /// `options`: method and normalization. `rate` must outlive this.
  ReductionSweep(const Model& model, const ModelReduction& reduction, const RateOnSamples& rate,
                 ReductionOptions options, const Progress& progress);

  double rate(int vectors) const;

  /// The fewest vectors of the wanted rate; all if no number has it. The rate need not rise evenly
  /// with the vectors, so the search begins at one, in steps that grow to a fiftieth.
  int fewest(double wanted, const Progress& progress) const;

  /// Points (fraction of the vectors, rate), ascending to all vectors.
  std::vector<std::pair<double, double>> curve() const;

 private:
  const RateOnSamples& rate_;
  int most_;  // vectors of the cue that has most
  std::vector<std::unique_ptr<const Reduction>> reductions_;
};

}  // namespace place_recognition
