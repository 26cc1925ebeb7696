#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace place_recognition {

/// A sample of a run's images by which the run is recognized wherever it lies: also a part of it,
/// fewer of its cameras, or the same run with a few more images. It consists of the smallest hashes
/// of the images, a bottom-k sketch (A. Broder, "On the resemblance and containment of documents",
/// 1997; K. Beyer et al., "On synopses for distinct-value estimation under multiset operations",
/// 2007). Hashes are as good as random numbers, so the images of any other run that fall below the
/// largest of them are a random sample of that run.
class RunSketch {
 public:
  static constexpr std::size_t kMaxHashes = 64;

  /// Adds the hash of an image. A hash that was added before changes nothing.
  void add(std::uint64_t hash);

  /// The smallest hashes, in ascending order.
  const std::vector<std::uint64_t>& hashes() const { return hashes_; }

  /// Whether nothing is known of the run, as in model files of earlier versions.
  bool empty() const { return hashes_.empty(); }

  /// The value up to which the sketch contains every hash that was added.
  std::uint64_t limit() const;

 private:
  std::vector<std::uint64_t> hashes_;
};

inline bool operator==(const RunSketch& a, const RunSketch& b) { return a.hashes() == b.hashes(); }

/// Whether more than half of the images of `run` are among those of the `learned` runs together,
/// as far as the sketches tell: by the hashes of `run` up to the limit of one of the others, or of
/// its own if that is lower. False if there are none.
bool isLearned(const RunSketch& run, const std::vector<RunSketch>& learned);

}  // namespace place_recognition
