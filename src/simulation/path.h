#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "simulation/camera.h"
#include "simulation/furniture.h"
#include "simulation/random.h"

namespace place_recognition::simulation {

/// An image to render.
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

/// About one metre apart, wherever the floor is free.
std::vector<Marker> markers(const std::vector<Footprint>& footprints);

/// Twelve images per marker, 30 degrees apart, clockwise as in the thesis (section 3.2); the
/// tripod's position varies slightly from run to run.
std::vector<Pose> tripodRun(const std::vector<Marker>& markers, double rate, Random random);

/// The robot's path: through all rooms and back along the corridor, 0.1 m per step.
std::vector<cv::Point2f> driveWay();

/// Images along that path, `rate` per second, at 0.5 m/s and slower in turns. The robot deviates
/// from the path by up to `stray` (m) along each axis.
std::vector<Pose> driveRun(double rate, float stray, Random random);

}  // namespace place_recognition::simulation
