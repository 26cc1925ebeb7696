#include "recognition/frames/colour_statistics.h"

#include <algorithm>

namespace place_recognition {

void ColourMoments::add(const Eigen::RowVector3d& colour) {
  count += 1;
  sum += colour;
  squares += colour.transpose() * colour;
}

void ColourMoments::add(const ColourMoments& other) {
  count += other.count;
  sum += other.sum;
  squares += other.squares;
}

ColourStatistics colourStatistics(const std::vector<ColourMoments>& places) {
  ColourStatistics statistics;
  const bool complete = std::all_of(places.begin(), places.end(),
                                    [](const ColourMoments& place) { return place.count > 0; });
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

std::vector<ColourMoments> colourMoments(const ColourStatistics& statistics,
                                         const std::vector<std::uint64_t>& images) {
  std::vector<ColourMoments> places(images.size());
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
