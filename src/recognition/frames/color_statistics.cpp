#include "recognition/frames/color_statistics.h"

#include <algorithm>

namespace place_recognition {

void ColorMoments::add(const Eigen::RowVector3d& color) {
  count += 1;
  sum += color;
  squares += color.transpose() * color;
}

void ColorMoments::add(const ColorMoments& other) {
  count += other.count;
  sum += other.sum;
  squares += other.squares;
}

ColorStatistics colorStatistics(const std::vector<ColorMoments>& places) {
  ColorStatistics statistics;
  const bool complete = std::all_of(places.begin(), places.end(),
                                    [](const ColorMoments& place) { return place.count > 0; });
  if (!complete) return statistics;
  statistics.means.resize(static_cast<Eigen::Index>(places.size()), 3);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  double count = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::RowVector3d mean = places[k].sum / places[k].count;
    statistics.means.row(static_cast<Eigen::Index>(k)) = mean;
    scatter += places[k].squares - places[k].count * mean.transpose() * mean;
    count += places[k].count;
  }
  statistics.covariance = scatter / count;
  return statistics;
}

std::vector<ColorMoments> colorMoments(const ColorStatistics& statistics,
                                       const std::vector<std::uint64_t>& images) {
  std::vector<ColorMoments> places(images.size());
  if (!statistics.known()) return places;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto count = static_cast<double>(images[k]);
    const Eigen::RowVector3d mean = statistics.means.row(static_cast<Eigen::Index>(k));
    places[k].count = count;
    places[k].sum = count * mean;
    places[k].squares = count * (statistics.covariance + mean.transpose() * mean);
  }
  return places;
}

}  // namespace place_recognition
