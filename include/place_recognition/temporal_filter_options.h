#pragma once

namespace place_recognition {

/// Options of TemporalFilter; for visit() and check(), see feature_options.h. If there is odometry,
/// metres and radians replace seconds.
struct TemporalFilterOptions {
  double dwell_time = 8;
  double dwell_distance = 4;
  double unknown_share = 0.03;
  double jump_share = 0.01;
  double decorrelation_time = 0.2;
  double decorrelation_distance = 0.1;
  double decorrelation_angle = 0.15;
  double outlier_share = 0.1;
  double minimum_confidence = 0.3;
  double minimum_dwell = 0.5;
  double maximum_gap = 10;
  double camera_gap = 1;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("dwell_time", self.dwell_time, "s, mean stay in a room, > 0");
    visitor("dwell_distance", self.dwell_distance, "m, mean distance travelled within a room, > 0");
    visitor("unknown_share", self.unknown_share,
            "fraction of the time spent in rooms that the model does not know, 0..0.5");
    visitor(
        "jump_share", self.jump_share,
        "fraction of the changes that lead to any room, adjoining or not (carried robots), 0..1");
    visitor("decorrelation_time", self.decorrelation_time,
            "s, frames closer than this share their evidence, > 0");
    visitor("decorrelation_distance", self.decorrelation_distance,
            "m, frames closer than this share their evidence, > 0");
    visitor("decorrelation_angle", self.decorrelation_angle,
            "rad, frames closer than this share their evidence, > 0");
    visitor("outlier_share", self.outlier_share,
            "fraction of frames without information, whatever their probabilities, 0.0001..1");
    visitor("minimum_confidence", self.minimum_confidence,
            "the answer is 'unknown' if no room has this probability, 0..1");
    visitor("minimum_dwell", self.minimum_dwell, "s, shortest time for which an answer stays");
    visitor("maximum_gap", self.maximum_gap,
            "s, everything is forgotten after a longer time without frames, > 0");
    visitor("camera_gap", self.camera_gap,
            "s, one of several cameras does not count if it is silent for longer, > 0");
  }
  /// Throws Error naming the first field out of range.
  void check() const;
};

}  // namespace place_recognition
