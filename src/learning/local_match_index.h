#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "learning/match_panels.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// Descriptor sets for the local match kernel (eq. 5.39-5.40). K_l decreases with distance, so the
/// best match of a descriptor is its nearest neighbour, which is found exactly in integers.
class LocalMatchIndex {
 public:
  LocalMatchIndex(double gamma, const std::vector<Feature>& sets);

  /// Computes Kernel::measure(x, set i) for the first sets, as many as `out` has elements. Throws
  /// Error if `x` is of another kind. Safe to call from several threads.
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const;

  std::size_t size() const { return sets_.size(); }
  /// Restores the sets.
  std::vector<Feature> vectors() const;

 private:
  /// Position of one set.
  struct Set {
    std::size_t first_panel;
    std::size_t size;  ///< descriptors
  };

  double measure(const std::vector<DescriptorBlock>& query, std::size_t query_size,
                 const Set& set) const;
  /// K_l at a squared distance between descriptors as stored.
  double localKernel(std::int32_t squared_distance) const;

  double gamma_;
  MatchPanels* match_panels_;
  std::vector<Set> sets_;
  std::vector<DescriptorPanel> panels_;
};

}  // namespace place_recognition
