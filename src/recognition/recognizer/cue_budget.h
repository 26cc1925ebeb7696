#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace place_recognition {

/// Which cues of a frame there is time for, by what each of them took in the frames before. Not
/// thread-safe.
class CueBudget {
 public:
  using Clock = std::function<double()>;  ///< s, ascending
  static double steadySeconds();

  explicit CueBudget(std::size_t cues, Clock clock = steadySeconds);

  /// A frame that may take `seconds` from now on; infinity: any time.
  void begin(double seconds);

  /// All cues, the one that is expected to take least first. Constant during a frame.
  const std::vector<std::size_t>& order() const { return order_; }

  /// Whether the cue is expected to be done in time. What a cue takes is expected to be what it
  /// took last if that was more than expected, and else to approach it. A cue that was not computed
  /// counts as if it had been as much slower or faster than expected as those that were, and each
  /// time that it is not allowed a little less, so that it gets another chance.
  bool allows(std::size_t cue);

  /// Calls `work`, which computes a cue, and remembers what that took.
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
  std::vector<double> expected_;  // s, one per cue; 0: it was never computed
  std::vector<bool> computed_;    // of each cue: in this frame
  double spent_ = 0;              // s, on the cues of this frame that had been computed before
  double foreseen_ = 0;           // s, what was expected of them
  std::vector<std::size_t> order_;
};

}  // namespace place_recognition
