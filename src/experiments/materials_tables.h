#pragma once

#include <vector>

#include "experiments/experiment.h"
#include "experiments/materials_experiment.h"
#include "experiments/reduction_curve.h"

namespace place_recognition {

/// How many vectors a tau leaves.
struct TauPoint {
  double tau = 0;
  int vectors = 0;
};

/// How one classifier of chapter 7 fared; vectors: one for each tested sample.
struct MaterialResult {
  MaterialClassifier classifier;
  double validation = 0;  ///< mean rate on samples left out of the training samples
  std::vector<std::vector<ReductionCurve>> curves;  ///< normalized, not normalized
  std::vector<std::vector<TauPoint>> taus;          ///< not normalized; empty if not measured
};

/// Tables 7.1 to 7.6 and the curves of figures 7.2 to 7.4. Tables 7.3 to 7.6 and figure 7.2 show
/// the parameters of each kernel whose `validation` is best.
Findings materialFindings(const std::vector<MaterialResult>& results);

}  // namespace place_recognition
