#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

class SupportSet;
struct BinarySvms;

/// Support vector machines of all places over one shared support set (thesis chapter 5): feature
/// in, one margin a place out. Immutable; safe to share between threads.
class Classifier {
 public:
  /// `machines` over `vectors` (as many rows of weights), each recorded in one of `vector_places`;
  /// vectors that no machine uses are dropped.
  Classifier(const KernelOptions& kernel, BinarySvms machines, std::vector<Feature> vectors,
             const std::vector<int>& vector_places);
  /// The same of vectors that are laid out already, each used by some machine.
  Classifier(BinarySvms machines, SupportSet support_set, std::vector<int> vector_places);
  ~Classifier();
  Classifier(Classifier&&) noexcept;
  Classifier& operator=(Classifier&&) noexcept;

  /// Place margins of `feature` (not missing, of the kind trained on), `places()` elements.
  /// `kernel_values` is scratch memory, reused between calls.
  void margins(const Feature& feature, Eigen::VectorXd& kernel_values,
               Eigen::RowVectorXd& place_margins) const;

  std::size_t places() const;
  std::size_t supportVectorCount() const;
  const SupportSet& supportSet() const { return *support_set_; }
  const BinarySvms& machines() const { return *machines_; }
  /// The place that each support vector was recorded in.
  const std::vector<int>& vectorPlaces() const { return vector_places_; }

 private:
  std::unique_ptr<SupportSet> support_set_;
  std::unique_ptr<BinarySvms> machines_;
  std::vector<int> vector_places_;
};

}  // namespace place_recognition
