#include <Eigen/Core>

namespace place_recognition {
namespace {

/// Eigen cuts the sums of large products where the caches of the processor are full. With sizes of
/// its own, every processor adds in the same order, and a training gives the same bytes on all.
const bool kSet = [] {
  constexpr std::ptrdiff_t kKiB = 1024;
  Eigen::setCpuCacheSizes(32 * kKiB, 256 * kKiB, 2048 * kKiB);
  return true;
}();

}  // namespace
}  // namespace place_recognition
