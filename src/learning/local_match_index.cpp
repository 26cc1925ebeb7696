#include "learning/local_match_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/simd.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::size_t kDimension = DescriptorSet::kDimension;
/// Descriptors are stored in panels of kLanes, element by element: (k, lane).
constexpr std::size_t kLanes = 16;
/// Rows of the query that share one pass over a panel.
constexpr std::size_t kRows = 4;
/// Squared norm of what fills the last panel of a set: never the nearest.
constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max() / 2;

const DescriptorSet& descriptorsOf(const Feature& feature) {
  const auto* set = std::get_if<DescriptorSet>(&feature);
  if (!set || set->size() == 0) {
    throw Error("The kernel 'local-match' compares sets of local descriptors only.");
  }
  return *set;
}

std::int32_t squaredNorm(const std::uint8_t* descriptor) {
  std::int32_t sum = 0;
  for (std::size_t k = 0; k < kDimension; ++k) sum += descriptor[k] * descriptor[k];
  return sum;
}

/// Lowers row_nearest[0..kRows) and panel_nearest[0..kLanes) to the squared distances between
/// kRows descriptors and a panel. All numbers are integers below 2^24, exact in float.
PLACE_RECOGNITION_TARGET_CLONES
void matchPanels(const float* rows, const std::int32_t* row_norms, const float* panels,
                 const std::int32_t* panel_norms, std::size_t panel_count,
                 std::int32_t* row_nearest, std::int32_t* panel_nearest) {
  for (std::size_t p = 0; p < panel_count; ++p) {
    const float* panel = panels + p * kDimension * kLanes;
    float products[kRows][kLanes] = {};
    for (std::size_t k = 0; k < kDimension; ++k) {
      for (std::size_t r = 0; r < kRows; ++r) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          products[r][lane] += rows[r * kDimension + k] * panel[k * kLanes + lane];
        }
      }
    }
    for (std::size_t r = 0; r < kRows; ++r) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::int32_t distance = row_norms[r] + panel_norms[p * kLanes + lane] -
                                      2 * static_cast<std::int32_t>(products[r][lane]);
        row_nearest[r] = std::min(row_nearest[r], distance);
        panel_nearest[p * kLanes + lane] = std::min(panel_nearest[p * kLanes + lane], distance);
      }
    }
  }
}

}  // namespace

LocalMatchIndex::LocalMatchIndex(double gamma, const std::vector<Feature>& sets) : gamma_(gamma) {
  for (const Feature& feature : sets) {
    const DescriptorSet& set = descriptorsOf(feature);
    const std::size_t first_panel = squared_norms_.size() / kLanes;
    const std::size_t panel_count = (set.size() + kLanes - 1) / kLanes;
    sets_.push_back({first_panel, set.size()});
    squared_norms_.resize((first_panel + panel_count) * kLanes, kFar);
    panels_.resize(squared_norms_.size() * kDimension, 0);
    for (std::size_t i = 0; i < set.size(); ++i) {
      float* panel = &panels_[(first_panel + i / kLanes) * kLanes * kDimension];
      for (std::size_t k = 0; k < kDimension; ++k) panel[k * kLanes + i % kLanes] = set.row(i)[k];
      squared_norms_[first_panel * kLanes + i] = squaredNorm(set.row(i));
    }
  }
}

double LocalMatchIndex::meanKernel(const std::vector<std::int32_t>& squared_distances,
                                   std::size_t count) const {
  constexpr double kUnit = static_cast<double>(DescriptorSet::kUnit) * DescriptorSet::kUnit;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += std::exp(-gamma_ * squared_distances[i] / kUnit);
  return sum / static_cast<double>(count);
}

void LocalMatchIndex::measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const {
  if (sets_.empty()) return;
  const DescriptorSet& query = descriptorsOf(x);
  const std::size_t rows = (query.size() + kRows - 1) / kRows * kRows;
  std::vector<float> descriptors(rows * kDimension, 0);
  std::copy(query.descriptors.begin(), query.descriptors.end(), descriptors.begin());
  std::vector<std::int32_t> norms(rows, kFar);
  for (std::size_t i = 0; i < query.size(); ++i) norms[i] = squaredNorm(query.row(i));

  std::vector<std::int32_t> query_nearest;
  std::vector<std::int32_t> set_nearest;
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    const Set& set = sets_[s];
    const std::size_t panel_count = (set.size + kLanes - 1) / kLanes;
    query_nearest.assign(rows, std::numeric_limits<std::int32_t>::max());
    set_nearest.assign(panel_count * kLanes, std::numeric_limits<std::int32_t>::max());
    for (std::size_t r = 0; r < rows; r += kRows) {
      matchPanels(&descriptors[r * kDimension], &norms[r],
                  &panels_[set.first_panel * kLanes * kDimension],
                  &squared_norms_[set.first_panel * kLanes], panel_count, &query_nearest[r],
                  set_nearest.data());
    }
    out[static_cast<Eigen::Index>(s)] =
        0.5 * (meanKernel(query_nearest, query.size()) + meanKernel(set_nearest, set.size));
  }
}

}  // namespace place_recognition
