#include "ros/recognizer/camera_clocks.h"

#include <cmath>

namespace place_recognition {

std::optional<CameraClocks::Difference> CameraClocks::add(std::size_t camera, double stamp,
                                                          Arrival arrival) {
  constexpr double kTolerance = 5;  // s
  constexpr double kJustBefore = 0.25;
  last_[camera] = {stamp, arrival};
  for (std::size_t other = 0; other < last_.size(); ++other) {
    if (other == camera || !last_[other].arrival) continue;
    const std::chrono::duration<double> later = arrival - *last_[other].arrival;
    const double difference = stamp - last_[other].stamp - later.count();
    if (later.count() < kJustBefore && std::abs(difference) > kTolerance)
      return Difference{other, difference};
  }
  return std::nullopt;
}

}  // namespace place_recognition
