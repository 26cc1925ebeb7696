#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace place_recognition {

/// Ranks the members of a stream so that it can be thinned out further as it grows: of every 2^k
/// consecutive members, from a multiple of 2^k on, exactly one has a level of k or more, drawn at
/// random as the winner of a tournament. The first member of all wins every one.
class StratifiedLevels {
 public:
  explicit StratifiedLevels(std::uint64_t seed) : seed_(seed) {}

  /// Level of the next member, 0 or more.
  int next();

 private:
  std::uint64_t seed_;
  std::uint64_t seen_ = 0;
};

/// Which frames to keep of runs that may have more than fit into memory: of each place the same
/// fraction, spread evenly over its frames, which is halved as often as needed.
class HalvingSample {
 public:
  explicit HalvingSample(std::uint64_t seed) : seed_(seed) {}

  /// The level of the next frame of `place`; nothing if it is left out.
  std::optional<int> next(const std::string& place);

  /// From now on half as many frames are kept, of those to come as of those so far.
  void halve() { ++least_level_; }

  /// Whether a frame of `place` that had this level is still kept, to be asked once after each
  /// halve().
  bool keeps(const std::string& place, int level);

  /// How many frames of `place` are not.
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
