#include "learning/support_set.h"

#include <cassert>

namespace place_recognition {
namespace {

SupportSet::Index makeIndex(const Kernel& kernel, const std::vector<Feature>& vectors) {
  for (const Feature& vector : vectors) kernel.requireMeaningFor(vector);
  const Measure measure = kernel.type().measure;
  if (measure == Measure::kLocalMatch) return LocalMatchIndex(kernel.options().gamma, vectors);
  return InvertedIndex(measure, postingLists(measure, vectors));
}

SupportSet::Index makeIndex(const Kernel& kernel, PostingLists lists) {
  kernel.requireMeaningFor(lists);
  return InvertedIndex(kernel.type().measure, std::move(lists));
}

}  // namespace

SupportSet::SupportSet(const Kernel& kernel, const std::vector<Feature>& vectors)
    : kernel_(kernel), index_(makeIndex(kernel_, vectors)) {}

SupportSet::SupportSet(const Kernel& kernel, PostingLists lists)
    : kernel_(kernel), index_(makeIndex(kernel_, std::move(lists))) {}

void SupportSet::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  assert(static_cast<std::size_t>(out.size()) <= size());
  std::visit([&](const auto& index) { index.measures(x, out); }, index_);
}

void SupportSet::kernelValues(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  measures(x, out);
  out = out.unaryExpr([this](double measure) { return kernel_.value(measure); });
}

std::size_t SupportSet::size() const {
  return std::visit([](const auto& index) { return index.size(); }, index_);
}

std::vector<Feature> SupportSet::vectors() const {
  return std::visit([](const auto& index) { return index.vectors(); }, index_);
}

}  // namespace place_recognition
