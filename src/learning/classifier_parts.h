#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "learning/support_set.h"
#include "place_recognition/classifier.h"
#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// What a Classifier is made of, which other programs need not know.
struct ClassifierParts {
  BinarySvms machines;             ///< as many rows of weights as support vectors
  SupportSet support_set;          ///< each used by some machine
  std::vector<int> vector_places;  ///< the place that each was recorded in

  static const ClassifierParts& of(const Classifier& classifier) { return *classifier.parts_; }

  static Classifier assemble(ClassifierParts parts);
  /// Over `vectors` (as many rows of weights), each recorded in one of `vector_places`; vectors
  /// that no machine uses are dropped.
  static Classifier assemble(const KernelOptions& kernel, BinarySvms machines,
                             std::vector<Feature> vectors, const std::vector<int>& vector_places);
};

}  // namespace place_recognition
