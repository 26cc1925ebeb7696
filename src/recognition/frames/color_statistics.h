#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "place_recognition/color_statistics.h"

namespace place_recognition {

/// Moments of the colours of the images of one place.
struct ColorMoments {
  double count = 0;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::RowVector3d& color);
  void add(const ColorMoments& other);
};

/// Not known() if a place has no image.
ColorStatistics colorStatistics(const std::vector<ColorMoments>& places);

/// What colorStatistics() was given, but that every place has the same covariance. `images`: their
/// number, of each place. No images if the statistics are not known.
std::vector<ColorMoments> colorMoments(const ColorStatistics& statistics,
                                       const std::vector<std::uint64_t>& images);

}  // namespace place_recognition
