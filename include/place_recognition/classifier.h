#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "place_recognition/feature.h"

namespace place_recognition {

struct ClassifierParts;

/// Support vector machines of all places over one shared support set (thesis chapter 5): maps a
/// feature to one decision value per place. Created by training or by reading a model. Immutable;
/// safe to share between threads. Copies share the support set.
class Classifier {
 public:
  /// Computes the decision values of `feature` (not missing, of the kind trained on): `places()`
  /// elements. `kernel_values` is scratch memory, reused between calls.
  void decisionValues(const Feature& feature, Eigen::VectorXd& kernel_values,
                      Eigen::RowVectorXd& place_values) const;

  std::size_t places() const;
  std::size_t supportVectorCount() const;

 private:
  friend struct ClassifierParts;
  explicit Classifier(std::shared_ptr<const ClassifierParts> parts);

  std::shared_ptr<const ClassifierParts> parts_;
};

}  // namespace place_recognition
