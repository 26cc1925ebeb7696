#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "learning/support_set.h"
#include "place_recognition/classifier.h"
#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// Where a support vector was recorded, and how many times that place has been learned again since.
struct VectorOrigin {
  int place = 0;
  int age = 0;
};

/// What a Classifier is made of, which other programs need not know.
struct ClassifierParts {
  BinarySvms machines;                ///< as many rows of weights as support vectors
  SupportSet support_set;             ///< each used by some machine
  std::vector<VectorOrigin> origins;  ///< of each

  static const ClassifierParts& of(const Classifier& classifier) { return *classifier.parts_; }

  static Classifier assemble(ClassifierParts parts);
  /// Over `vectors` (as many rows of weights), with their `origins`; vectors that no machine
  /// uses are dropped.
  static Classifier assemble(const KernelOptions& kernel, BinarySvms machines,
                             std::vector<Feature> vectors,
                             const std::vector<VectorOrigin>& origins);
};

}  // namespace place_recognition
