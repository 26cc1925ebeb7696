#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace place_recognition {

/// Three or more corners in order, in either direction; the last is connected to the first. An edge
/// has the number of its first corner.
using Polygon = std::vector<Eigen::Vector2d>;

/// Whether a ray from `point` along x crosses the border an odd number of times.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

double distanceToBorder(const Polygon& polygon, const Eigen::Vector2d& point);

double areaOf(const Polygon& polygon);

/// The first two edges that cross in their interiors; corners and edges that only touch do not
/// count.
std::optional<std::pair<std::size_t, std::size_t>> crossingEdges(const Polygon& polygon);

/// Moments of a point distributed uniformly over an area.
struct UniformDistribution {
  double area = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// The distribution over a polygon whose edges do not cross and whose area is not 0. By Green's
/// theorem, with corners p_i, a_i = p_i x p_{i+1} and 2 A = sum a_i:
///   mean = sum a_i (p_i + p_{i+1}) / 6A,
///   E[p p'] = sum a_i (p_i p_i' + p_{i+1} p_{i+1}' + (p_i + p_{i+1})(p_i + p_{i+1})') / 24A.
UniformDistribution uniformDistribution(const Polygon& polygon);

/// The distribution over several areas together. Where they overlap, their densities add up.
UniformDistribution uniformDistribution(const std::vector<UniformDistribution>& parts);

/// Counterclockwise.
using Triangle = std::array<Eigen::Vector2d, 3>;

/// Covers a polygon whose edges do not cross with triangles that do not overlap, by ear clipping
/// (Meisters 1975). Edges and corners may touch, as they do if a corridor encloses a block.
std::vector<Triangle> triangulated(Polygon polygon);

}  // namespace place_recognition
