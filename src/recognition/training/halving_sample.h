#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace place_recognition {

/// Assigns levels to the members of a stream so that it can be thinned out further as it grows: of
/// every 2^k consecutive members, starting at a multiple of 2^k, exactly one has level k or higher.
/// It is drawn at random as the winner of a tournament; the first member of all wins every
/// tournament.
class StratifiedLevels {
 public:
  explicit StratifiedLevels(std::uint64_t seed) : seed_(seed) {}

  /// Level of the next member, 0 or more.
  int next();

 private:
  std::uint64_t seed_;
  std::uint64_t seen_ = 0;
};

/// Selects the frames to keep from runs that may not fit into memory: the same fraction of each
/// place, spread evenly over its frames, halved as often as needed.
class HalvingSample {
 public:
  explicit HalvingSample(std::uint64_t seed) : seed_(seed) {}

  /// The level of the next frame of `place`; nothing if it is not kept.
  std::optional<int> next(const std::string& place);

  /// Halves the fraction kept, for frames already seen and for those to come.
  void halve() { ++least_level_; }

  /// Whether a frame of `place` with this level is still kept. Call it once per frame after each
  /// halve().
  bool keeps(const std::string& place, int level);

  /// Number of frames of `place` not kept.
  std::size_t leftOut(const std::string& place) const;

 private:
  struct Place {
    StratifiedLevels levels;
    std::size_t left_out = 0;
  };

  std::uint64_t seed_;
  int least_level_ = 0;
  std::map<std::string, Place> places_;
};

}  // namespace place_recognition
