#pragma once

#include <Eigen/Core>

#include "place_recognition/temporal_filter.h"

namespace place_recognition {

/// An answer over time, if the robot is in one of the rooms.
struct RoomAnswer {
  int place = 0;                     ///< the most probable room: index in Model::places
  bool known = false;                ///< whether the answer over time is a room, not 'unknown'
  double confidence = 0;             ///< probability of `place`
  double evidence = 0;               ///< that the robot is in any of the rooms, 0..1
  Eigen::RowVectorXd probabilities;  ///< one per room; sum to 1, also without any evidence
};

RoomAnswer roomAnswer(const FilteredAnswer& answer);

}  // namespace place_recognition
