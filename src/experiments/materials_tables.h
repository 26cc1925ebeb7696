#pragma once

#include <string>
#include <vector>

#include "experiments/experiment.h"
#include "experiments/reduction_curve.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// A classifier of chapter 7.
struct MaterialClassifier {
  std::string feature;  ///< one of kMaterialFeatures
  int samples = 0;      ///< of each material that it is trained on
  KernelOptions kernel;
  SvmOptions svm;
};

/// How many vectors a tau leaves.
struct TauPoint {
  double tau = 0;
  int vectors = 0;
};

/// How a classifier fared on one split into training and test samples.
struct MaterialOutcome {
  double validation = 0;       ///< mean rate on parts of the training images that were left out
  double rate = 0;             ///< on the test images, before reduction
  int vectors = 0;             ///< before reduction
  std::vector<int> fewest;     ///< vectors at each of kMaterialFractions
  ReductionCurve curve;        ///< normalized; empty if not measured
  std::vector<TauPoint> taus;  ///< not normalized; empty if not measured
};

struct MaterialResult {
  MaterialClassifier classifier;
  std::vector<MaterialOutcome> outcomes;  ///< of each split
};

/// Tables 7.1 to 7.6 and the curves of figures 7.2 to 7.4, of the classifiers trained on most
/// samples; and two tables that the thesis leaves out: what fewer training samples cost, and the
/// whole grid at a glance. Where a table tells no parameters of the kernel, they are those of the
/// best mean `validation`. Classifiers whose mean rate is below 30 % before reduction are rejected
/// (section 7.2).
Findings materialFindings(const std::vector<MaterialResult>& results);

}  // namespace place_recognition
