#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "place_recognition/colour_statistics.h"

namespace place_recognition {

/// Moments of the colours of the images of one place.
struct ColourMoments {
  double count = 0;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::RowVector3d& colour);
  void add(const ColourMoments& other);
};

/// Not known() if a place has no image.
ColourStatistics colourStatistics(const std::vector<ColourMoments>& places);

/// The arguments that colourStatistics() was given, except that every place has the same
/// covariance. `images`: number of images of each place. Empty moments if the statistics are not
/// known.
std::vector<ColourMoments> colourMoments(const ColourStatistics& statistics,
                                         const std::vector<std::uint64_t>& images);

}  // namespace place_recognition
