#pragma once

#include <cstdint>
#include <vector>

#include "learning/support_index.h"

namespace place_recognition {

/// Descriptor sets for the local match kernel (eq. 5.39-5.40). K_l falls with the distance, so the
/// best match of a descriptor is its nearest neighbour; squared distances |a|^2 + |b|^2 - 2 a'b of
/// integer descriptors are exact, and the products a'b are computed in blocks.
class LocalMatchIndex : public SupportIndex {
 public:
  LocalMatchIndex(double gamma, const std::vector<Feature>& sets);
  void measures(const Feature& x, Eigen::Ref<Eigen::VectorXd> out) const override;

 private:
  /// Where one set stands.
  struct Set {
    std::size_t first_panel;
    std::size_t size;
  };

  /// Mean of K_l over squared distances of descriptors as they are stored.
  double meanKernel(const std::vector<std::int32_t>& squared_distances, std::size_t count) const;

  double gamma_;
  std::vector<Set> sets_;
  std::vector<float> panels_;
  std::vector<std::int32_t> squared_norms_;
};

}  // namespace place_recognition
