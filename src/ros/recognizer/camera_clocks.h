#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace place_recognition {

/// Compares the clocks of several cameras by the stamps and the arrival of their images. Not
/// thread-safe.
class CameraClocks {
 public:
  using Arrival = std::chrono::steady_clock::time_point;

  explicit CameraClocks(std::size_t cameras) : last_(cameras) {}

  /// The clock of one camera against that of another.
  struct Difference {
    std::size_t other;
    double seconds;  ///< > 0: the other one is behind
  };

  /// Adds an image with `stamp`, s, of `camera`. Returns the difference to the first camera that
  /// has sent an image just before and whose clock differs by more than 5 s, which a replay at ten
  /// times the speed does not reach; nothing if there is none.
  std::optional<Difference> add(std::size_t camera, double stamp, Arrival arrival);

 private:
  struct Image {
    double stamp = 0;
    std::optional<Arrival> arrival;  // none: no image yet
  };
  std::vector<Image> last_;  // by camera
};

}  // namespace place_recognition
