#pragma once

#include <ros/time.h>

namespace place_recognition {

/// Not a ros::Duration, which cannot represent every difference: a clock that was not set may start
/// in 1970.
inline double secondsBetween(const ros::Time& from, const ros::Time& to) {
  return to.toSec() - from.toSec();
}

}  // namespace place_recognition
