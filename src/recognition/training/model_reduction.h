#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "learning/binary_svms.h"
#include "learning/reduction.h"
#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// Change of decision values by a reduction, over all machines and all rows of the kernel matrices.
struct DecisionValueChange {
  double largest = 0;
  double mean = 0;
};

/// Reduces the support vectors of a trained model (thesis chapter 6), any number of times.
class ModelReduction {
 public:
  /// The rows of the kernel matrix K (eq. 6.19) are the training vectors in `training` or, without
  /// it, the model's support vectors, the only vectors that a saved model contains.
  ModelReduction(const Model& model, const Samples* training, const Progress& progress);

  /// The machines that `options` request, one set per cue, over the original vectors.
  std::vector<BinarySvms> reduce(const ReductionOptions& options, const Progress& progress) const;

  /// The same for any number of vectors that the options allow, one per cue.
  std::vector<std::unique_ptr<const Reduction>> factorize(const ReductionOptions& options,
                                                          const Progress& progress) const;

  DecisionValueChange change(const std::vector<BinarySvms>& machines) const;

 private:
  const Model& model_;
  std::vector<Eigen::MatrixXd> kernel_values_;  // one per cue
};

/// Rate of a model's machines on labelled samples.
class RateOnSamples {
 public:
  /// Throws Error if the samples show a place unknown to the model.
  RateOnSamples(const Model& model, const Samples& samples, const Progress& progress);

  /// Mean of the places' rates, 0..1, with `machines` (one set per cue) instead of the model's own.
  double operator()(const std::vector<BinarySvms>& machines) const;

 private:
  const Model& model_;
  std::vector<std::vector<int>> rows_;          // [cue]: the samples that have its feature
  std::vector<Eigen::MatrixXd> kernel_values_;  // [cue]: one row per such sample
  std::vector<int> truth_;
};

/// The model's own machines, one set per cue.
std::vector<BinarySvms> machinesOf(const Model& model);

/// `model` with `machines`, one set per cue, instead of its own, and with `options` among its
/// options. It is not validated. Calibration and threshold stay as they were fitted. Since frames
/// look less familiar to fewer vectors, the evidence is shifted by what the support vectors
/// themselves lose on average.
Model withMachines(Model model, std::vector<BinarySvms> machines, const ReductionOptions& options);

/// Milliseconds to compare the features of one image with all support vectors of all cues: the
/// median over some images of `features` ([cue][image]). The rest of a frame's time, the extraction
/// of features, does not depend on the support vectors.
double comparisonMilliseconds(const Model& model,
                              const std::vector<std::vector<Feature>>& features);

}  // namespace place_recognition
