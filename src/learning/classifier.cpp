#include "place_recognition/classifier.h"

#include <cassert>

#include "learning/classifier_parts.h"
#include "learning/selection.h"

namespace place_recognition {

Classifier ClassifierParts::assemble(ClassifierParts parts) {
  assert(supportVectors(parts.machines).size() == parts.support_set.size());
  assert(parts.origins.size() == parts.support_set.size());
  return Classifier(std::make_shared<const ClassifierParts>(std::move(parts)));
}

Classifier ClassifierParts::assemble(const KernelOptions& kernel, BinarySvms machines,
                                     std::vector<Feature> vectors,
                                     const std::vector<VectorOrigin>& origins) {
  assert(machines.weights.rows() == static_cast<Eigen::Index>(vectors.size()));
  assert(origins.size() == vectors.size());
  const std::vector<int> used = supportVectors(machines);
  std::vector<Feature> kept;
  for (const int i : used) kept.push_back(std::move(vectors[static_cast<std::size_t>(i)]));
  machines.weights = pickRows(machines.weights, used);
  return assemble({std::move(machines), SupportSet(Kernel(kernel), kept), pick(origins, used)});
}

Classifier::Classifier(std::shared_ptr<const ClassifierParts> parts) : parts_(std::move(parts)) {}

void Classifier::decisionValues(const Feature& feature, Eigen::VectorXd& kernel_values,
                                Eigen::RowVectorXd& place_values) const {
  const auto& [machines, support_set, origins] = *parts_;
  kernel_values.resize(static_cast<Eigen::Index>(support_set.size()));
  support_set.kernelValues(feature, kernel_values);
  place_values = placeValues(machines, machines.decisionValues(kernel_values.transpose()));
}

std::size_t Classifier::places() const { return parts_->machines.places; }

std::size_t Classifier::supportVectorCount() const { return parts_->support_set.size(); }

}  // namespace place_recognition
