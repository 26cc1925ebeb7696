#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>

#include <cstdint>

namespace place_recognition {

/// The time span of a bag: of its images, and of all messages that are not separated from them by a
/// gap of more than ten minutes. If a clock was not set, so that groups of images are more than a
/// day apart, the larger group counts.
struct BagTimeSpan {
  ros::Time begin;
  ros::Time end;
  std::uint32_t other_images = 0;  ///< number of images in the other groups
};

BagTimeSpan timeSpan(const rosbag::Bag& bag);

}  // namespace place_recognition
