#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "learning/support_set.h"
#include "place_recognition/classifier.h"
#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// The place of a support vector, and how many times that place has been learned again since.
struct VectorOrigin {
  int place = 0;
  int age = 0;
};

/// The parts of a Classifier, hidden from other programs.
struct ClassifierParts {
  BinarySvms machines;                ///< one row of weights per support vector
  SupportSet support_set;             ///< each vector is used by some machine
  std::vector<VectorOrigin> origins;  ///< of each vector

  static const ClassifierParts& of(const Classifier& classifier) { return *classifier.parts_; }

  static Classifier assemble(ClassifierParts parts);
  /// Assembles a classifier over `vectors` (one per row of weights) with their `origins`; drops
  /// vectors that no machine uses.
  static Classifier assemble(const KernelOptions& kernel, BinarySvms machines,
                             std::vector<Feature> vectors,
                             const std::vector<VectorOrigin>& origins);
};

}  // namespace place_recognition
