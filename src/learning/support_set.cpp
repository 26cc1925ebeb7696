#include "learning/support_set.h"

#include <cassert>

#include "learning/local_match_index.h"
#include "learning/vector_index.h"

namespace place_recognition {
namespace {

std::unique_ptr<SupportIndex> makeIndex(const Kernel& kernel, const std::vector<Feature>& vectors) {
  for (const Feature& vector : vectors) kernel.requireMeaningFor(vector);
  if (kernel.type().measure == Measure::kLocalMatch) {
    return std::make_unique<LocalMatchIndex>(kernel.options().gamma, vectors);
  }
  return std::make_unique<VectorIndex>(kernel.type().measure, vectors);
}

}  // namespace

SupportSet::SupportSet(const Kernel& kernel, std::vector<Feature> vectors)
    : kernel_(kernel), vectors_(std::move(vectors)), index_(makeIndex(kernel_, vectors_)) {}

void SupportSet::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  assert(static_cast<std::size_t>(out.size()) <= size());
  index_->measures(x, out);
}

void SupportSet::kernelValues(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  measures(x, out);
  out = out.unaryExpr([this](double measure) { return kernel_.value(measure); });
}

}  // namespace place_recognition
