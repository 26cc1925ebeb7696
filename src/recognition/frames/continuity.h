#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "place_recognition/recording.h"

namespace place_recognition {

/// Largest gap between two parts of a split recording, s: a message or two, or the next image of a
/// camera that sends one every `interval`, s.
inline double largestGapOfParts(double interval) { return std::max(2.0, 1.5 * interval); }

/// Tells which of the recordings that are read one after another continue the one before, like the
/// parts of a split recording. Not thread-safe.
class Continuity {
 public:
  /// Begins the next recording, with these Recording::cameras().
  void begin(const std::vector<std::string>& cameras);

  /// Takes the next frame of the recording. Every frame counts, also one without a label or an
  /// image. Returns whether it begins a stream: the first frame of a recording does, unless the
  /// recording continues the one before.
  bool beginsStream(const Frame& frame);

  /// Whether the recording, of which a frame was taken, has the cameras of the one before, and
  /// starts at most largestGapOfParts() from its end. The border may lie between the images of one
  /// moment, so the first frame has to be later only than the last one of its own camera.
  bool continues() const { return continues_; }

 private:
  bool followsClosely(double stamp) const;

  std::vector<std::string> cameras_;
  std::vector<double> last_stamps_;  // of each camera; -infinity: no frame
  double begin_ = 0;                 // stamp of the first frame of the stream, s
  double moments_ = 0;               // number of its frames, per camera
  bool starts_ = true;               // no frame of the recording was taken
  bool may_continue_ = false;
  bool continues_ = false;
};

}  // namespace place_recognition
