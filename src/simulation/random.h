#pragma once

#include <cmath>
#include <cstdint>

namespace place_recognition::simulation {

/// A small generator (SplitMix64) that gives the same numbers with every standard library, unlike
/// std::uniform_real_distribution and similar.
class Random {
 public:
  /// Generators with the same seed and different streams are independent of each other.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(seed * 0x9E3779B97F4A7C15ull ^ (stream + 1) * 0xD1B54A32D192ED03ull) {
    next();
  }

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

  /// In [0, 1).
  float uniform() { return static_cast<float>(next() >> 40) * (1.0f / 16777216.0f); }
  float uniform(float low, float high) { return low + (high - low) * uniform(); }

  /// In 0..count-1.
  int integer(int count) {
    return static_cast<int>(((next() >> 32) * static_cast<std::uint64_t>(count)) >> 32);
  }

  bool chance(float probability) { return uniform() < probability; }

  /// Mean 0, deviation 1 (Box-Muller, one of the pair).
  float normal() {
    const float radius = std::sqrt(-2.0f * std::log(1.0f - uniform()));
    return radius * std::cos(6.2831853f * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace place_recognition::simulation
