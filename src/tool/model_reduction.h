#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/machines.h"
#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "recognition/samples.h"

namespace place_recognition::tool {

/// The machines of a model after reduction, one set a cue, over the vectors they had before.
struct ReducedMachines {
  std::vector<Machines> machines;
  double max_margin_change = 0;  ///< over all machines and all rows of the kernel matrix
  double mean_margin_change = 0;
};

/// Reduces the support vectors of a trained model (thesis chapter 6), as often as one likes.
class ModelReduction {
 public:
  /// The rows of the kernel matrix K (eq. 6.19) are the training vectors of `training` or, without
  /// it, the model's support vectors, all that a saved model still has of them.
  ModelReduction(const Model& model, const Samples* training, const Progress& progress);

  /// `options.support_vectors` counts for each cue.
  ReducedMachines reduce(const ReductionOptions& options, const Progress& progress) const;

 private:
  const Model& model_;
  std::vector<Eigen::MatrixXd> kernel_values_;  // one a cue
};

/// How well machines of a model name the places of labelled samples.
class RateOnSamples {
 public:
  /// Throws Error if the samples show a place that the model does not know.
  RateOnSamples(const Model& model, const Samples& samples, const Progress& progress);

  /// Mean of the places' rates, 0..1, with `machines` (one set a cue) instead of the model's own.
  double operator()(const std::vector<Machines>& machines) const;

 private:
  const Model& model_;
  std::vector<std::vector<int>> rows_;          // [cue]: the samples that have its feature
  std::vector<Eigen::MatrixXd> kernel_values_;  // [cue]: a row for each of these
  std::vector<int> truth_;
};

/// The model's own machines, one set a cue.
std::vector<Machines> machinesOf(const Model& model);

/// `model` with `reduced` machines in place of its own and `options` among its options. Calibration
/// and threshold stay as they were fitted.
Model withMachines(Model model, ReducedMachines reduced, const ReductionOptions& options);

}  // namespace place_recognition::tool
