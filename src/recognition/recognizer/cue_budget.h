#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace place_recognition {

/// Decides which cues of a frame can be computed in time, from their times in earlier frames. Cues
/// that are computed together count as one. Not thread-safe.
class CueBudget {
 public:
  using Clock = std::function<double()>;  ///< s, ascending
  static double steadySeconds();

  explicit CueBudget(std::size_t cues, Clock clock = steadySeconds);

  /// Begins a frame that may take `seconds` from now on; infinity: no limit.
  void begin(double seconds);

  /// All cues, the quickest expected first. Constant during a frame.
  const std::vector<std::size_t>& order() const { return order_; }

  /// Whether the cue is expected to finish in time. The expected time of a cue rises to its last
  /// time at once, and falls towards it gradually. For cues that were not computed it changes by
  /// the same ratio as for those that were.
  bool fits(std::size_t cue) const;

  /// Leaves out a cue that does not fit. Its expected time decreases a little, so that the cue is
  /// tried again some day.
  void leaveOut(std::size_t cue);

  /// Calls `work`, which computes a cue, and measures its time.
  template <typename Work>
  void time(std::size_t cue, const Work& work) {
    const double start = clock_();
    work();
    finish(cue, clock_() - start);
  }

 private:
  void finish(std::size_t cue, double seconds);
  void remember(std::size_t cue, double seconds);

  Clock clock_;
  double end_ = std::numeric_limits<double>::infinity();
  std::vector<double> expected_;  // s, one per cue; 0: never computed
  std::vector<bool> computed_;    // by cue: in this frame
  double spent_ = 0;              // s, on cues of this frame that were computed in earlier ones
  double foreseen_ = 0;           // s, expected for them
  std::vector<std::size_t> order_;
};

}  // namespace place_recognition
