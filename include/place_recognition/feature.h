#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace place_recognition {

/// A sparse vector: the non-zero elements of a vector of up to 2^64 dimensions, for example a
/// composed receptive field histogram (thesis section 4.2). `indices` are strictly ascending and
/// `values`, of the same size, are finite and not zero (positive in a histogram).
struct SparseVector {
  std::vector<std::uint64_t> indices;
  std::vector<float> values;

  std::size_t size() const { return indices.size(); }
};

/// A dense vector of fixed dimension, for example an LBP histogram. Values are finite.
struct DenseVector {
  std::vector<float> values;
};

/// The local descriptors of one image (thesis section 4.3), stored one after another; their order
/// has no meaning. SIFT descriptors are integers 0..255, so squared distances are exact.
struct DescriptorSet {
  static constexpr std::size_t kDimension = 128;
  static constexpr int kUnit = 512;       ///< SIFT's scale for a descriptor of norm one
  std::vector<std::uint8_t> descriptors;  ///< size() x kDimension, row-major.

  std::size_t size() const { return descriptors.size() / kDimension; }
  const std::uint8_t* row(std::size_t i) const { return descriptors.data() + i * kDimension; }
};

/// The feature extracted from one image. std::monostate: the image has none, for example because it
/// shows fewer interest points than the extractor requires.
using Feature = std::variant<std::monostate, SparseVector, DenseVector, DescriptorSet>;

inline bool isMissing(const Feature& feature) {
  return std::holds_alternative<std::monostate>(feature);
}

}  // namespace place_recognition
