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
  int samples = 0;      ///< number per material that it is trained on
  KernelOptions kernel;
  SvmOptions svm;
};

/// The number of vectors left by a tau.
struct TauPoint {
  double tau = 0;
  int vectors = 0;
};

/// The result of a classifier on one split into training and test samples.
struct MaterialOutcome {
  double validation = 0;       ///< mean rate on held-out parts of the training images
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

/// Tables 7.1 to 7.6 and the curves of figures 7.2 to 7.4, for the classifiers trained on the most
/// samples; and two tables that are not in the thesis: the effect of fewer training samples, and a
/// summary of the whole grid. If a table does not state the kernel's parameters, they are those
/// with the best mean `validation`. Classifiers whose mean rate before reduction is less than 30 %
/// are rejected (section 7.2).
Findings materialFindings(const std::vector<MaterialResult>& results);

}  // namespace place_recognition
