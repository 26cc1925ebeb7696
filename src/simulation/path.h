#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "simulation/camera.h"
#include "simulation/furniture.h"
#include "simulation/random.h"

namespace place_recognition::simulation {

/// A picture to be taken.
struct Pose {
  std::string room;
  std::string name;  ///< file stem
  double stamp;      ///< s since the start of the run
  View view;
};

/// A cross on the floor for the tripod.
struct Marker {
  std::string room;
  int number;  ///< from 1, within the room
  cv::Point2f at;
};

/// About a metre apart, wherever the floor is free.
std::vector<Marker> markers(const std::vector<Footprint>& footprints);

/// Twelve pictures from every marker, 30 degrees apart, clockwise as in the thesis (section 3.2);
/// a tripod never stands quite as it did the last time.
std::vector<Pose> tripodRun(const std::vector<Marker>& markers, double rate, Random random);

/// The way of the robot: through all rooms and back through the corridor, 0.1 m a step.
std::vector<cv::Point2f> driveWay();

/// Pictures on that way, `rate` a second, at 0.5 m/s and slower in turns. The robot passes where
/// the way does, give or take `stray` (m) along each axis.
std::vector<Pose> driveRun(double rate, float stray, Random random);

}  // namespace place_recognition::simulation
