#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// Random features for tests, reproducible by the seed.
class RandomFeatures {
 public:
  explicit RandomFeatures(unsigned seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_()) / 4294967296.0;
  }

  /// Returns a normalized histogram. The probability that bin i of `bins` is not empty falls with
  /// i, so some bins are common to most histograms and others are rare.
  SparseVector histogram(std::size_t bins) {
    SparseVector histogram;
    float sum = 0;
    for (std::uint64_t i = 0; i < bins; ++i) {
      if (uniform(0, 1) > 5.0 / (5.0 + static_cast<double>(i))) continue;
      histogram.indices.push_back(i * 0x0123456789ABCDull);
      histogram.values.push_back(static_cast<float>(uniform(0.001, 1)));
      sum += histogram.values.back();
    }
    for (float& value : histogram.values) value /= sum;
    return histogram;
  }

  DenseVector dense(std::size_t dimension, double low = 0, double high = 1) {
    DenseVector vector;
    for (std::size_t i = 0; i < dimension; ++i) {
      vector.values.push_back(static_cast<float>(uniform(low, high)));
    }
    return vector;
  }

  DescriptorSet descriptors(std::size_t count) {
    DescriptorSet set;
    for (std::size_t i = 0; i < count * DescriptorSet::kDimension; ++i) {
      set.descriptors.push_back(static_cast<std::uint8_t>(uniform(0, 256)));
    }
    return set;
  }

 private:
  std::mt19937 generator_;
};

/// Points of the plane as features, for kernels with known properties.
inline Feature point(double x, double y) {
  return DenseVector{{static_cast<float>(x), static_cast<float>(y)}};
}

inline KernelOptions kernelOptions(const std::string& type, double gamma = 1) {
  KernelOptions options;
  options.type = type;
  options.gamma = gamma;
  return options;
}

}  // namespace place_recognition
