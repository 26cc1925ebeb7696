#include "learning/local_match_index.h"

#include <algorithm>
#include <cmath>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::size_t kRows = DescriptorBlock::kRows;
constexpr std::size_t kWidth = DescriptorPanel::kWidth;

const DescriptorSet& descriptorsOf(const Feature& feature) {
  const auto* set = std::get_if<DescriptorSet>(&feature);
  if (!set || set->size() == 0) {
    throw Error("The kernel 'local-match' compares sets of local descriptors only; skip others.");
  }
  return *set;
}

}  // namespace

LocalMatchIndex::LocalMatchIndex(double gamma, const std::vector<Feature>& sets)
    : gamma_(gamma), match_panels_(matchVariants().back().match) {
  for (const Feature& feature : sets) {
    const DescriptorSet& set = descriptorsOf(feature);
    const std::size_t first_panel = panels_.size();
    sets_.push_back({first_panel, set.size()});
    panels_.resize(first_panel + (set.size() + kWidth - 1) / kWidth);
    for (std::size_t i = 0; i < set.size(); ++i) {
      panels_[first_panel + i / kWidth].set(i % kWidth, set.row(i));
    }
  }
}

void LocalMatchIndex::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  if (sets_.empty()) return;
  const DescriptorSet& set = descriptorsOf(x);
  std::vector<DescriptorBlock> query((set.size() + kRows - 1) / kRows);
  for (std::size_t i = 0; i < set.size(); ++i) query[i / kRows].set(i % kRows, set.row(i));
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out[i] = measure(query, set.size(), sets_[static_cast<std::size_t>(i)]);
  }
}

std::vector<Feature> LocalMatchIndex::vectors() const {
  std::vector<Feature> features;
  for (const Set& set : sets_) {
    std::vector<std::uint8_t> descriptors(set.size * DescriptorSet::kDimension);
    for (std::size_t i = 0; i < set.size; ++i) {
      panels_[set.first_panel + i / kWidth].get(i % kWidth,
                                                &descriptors[i * DescriptorSet::kDimension]);
    }
    features.emplace_back(DescriptorSet{std::move(descriptors)});
  }
  return features;
}

double LocalMatchIndex::measure(const std::vector<DescriptorBlock>& query, std::size_t query_size,
                                const Set& set) const {
  const std::size_t panel_count = (set.size + kWidth - 1) / kWidth;
  std::vector<std::int32_t> set_nearest(panel_count * kWidth, DescriptorPanel::kFar);
  double query_sum = 0;
  for (std::size_t b = 0; b < query.size(); ++b) {
    BlockByPanel row_nearest;
    std::fill(&row_nearest[0][0], &row_nearest[0][0] + kRows * kWidth, DescriptorPanel::kFar);
    match_panels_(query[b], &panels_[set.first_panel], panel_count, row_nearest,
                  set_nearest.data());
    for (std::size_t row = 0; row < std::min(kRows, query_size - b * kRows); ++row) {
      query_sum += localKernel(*std::min_element(row_nearest[row], row_nearest[row] + kWidth));
    }
  }
  double set_sum = 0;
  for (std::size_t i = 0; i < set.size; ++i) set_sum += localKernel(set_nearest[i]);
  return 0.5 *
         (query_sum / static_cast<double>(query_size) + set_sum / static_cast<double>(set.size));
}

double LocalMatchIndex::localKernel(std::int32_t squared_distance) const {
  constexpr double kSquaredUnit = DescriptorSet::kUnit * DescriptorSet::kUnit;
  return std::exp(-gamma_ * squared_distance / kSquaredUnit);
}

}  // namespace place_recognition
