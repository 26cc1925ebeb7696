#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>

#include <utility>

namespace place_recognition {

/// The time of a bag: of its images, and of all messages that no gap of more than ten minutes sets
/// apart from them. Of images that a clock stamped which was not set, more than a day from the
/// others, the larger group counts.
std::pair<ros::Time, ros::Time> timeSpan(const rosbag::Bag& bag);

}  // namespace place_recognition
