#include "place_recognition/classifier.h"

#include <cassert>

#include "learning/binary_svms.h"
#include "learning/support_set.h"

namespace place_recognition {

Classifier::Classifier(const KernelOptions& kernel, BinarySvms machines,
                       std::vector<Feature> vectors, const std::vector<int>& vector_places) {
  assert(machines.weights.rows() == static_cast<Eigen::Index>(vectors.size()));
  assert(vector_places.size() == vectors.size());
  const std::vector<int> used = supportVectors(machines);
  Eigen::MatrixXd weights(used.size(), machines.weights.cols());
  std::vector<Feature> kept;
  for (std::size_t i = 0; i < used.size(); ++i) {
    weights.row(static_cast<Eigen::Index>(i)) = machines.weights.row(used[i]);
    const auto vector = static_cast<std::size_t>(used[i]);
    kept.push_back(std::move(vectors[vector]));
    vector_places_.push_back(vector_places[vector]);
  }
  machines.weights = std::move(weights);
  support_set_ = std::make_unique<SupportSet>(Kernel(kernel), kept);
  machines_ = std::make_unique<BinarySvms>(std::move(machines));
}

Classifier::Classifier(BinarySvms machines, SupportSet support_set, std::vector<int> vector_places)
    : support_set_(std::make_unique<SupportSet>(std::move(support_set))),
      machines_(std::make_unique<BinarySvms>(std::move(machines))),
      vector_places_(std::move(vector_places)) {
  assert(supportVectors(*machines_).size() == support_set_->size());
  assert(vector_places_.size() == support_set_->size());
}

Classifier::~Classifier() = default;
Classifier::Classifier(Classifier&&) noexcept = default;
Classifier& Classifier::operator=(Classifier&&) noexcept = default;

void Classifier::margins(const Feature& feature, Eigen::VectorXd& kernel_values,
                         Eigen::RowVectorXd& place_margins) const {
  kernel_values.resize(static_cast<Eigen::Index>(support_set_->size()));
  support_set_->kernelValues(feature, kernel_values);
  place_margins = placeMargins(*machines_, machines_->margins(kernel_values.transpose()));
}

std::size_t Classifier::places() const { return machines_->places; }

std::size_t Classifier::supportVectorCount() const { return support_set_->size(); }

}  // namespace place_recognition
