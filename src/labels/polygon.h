#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace place_recognition {

/// Corners in order, of either direction, three or more; the last is joined to the first. An edge
/// is numbered by its first corner.
using Polygon = std::vector<Eigen::Vector2d>;

/// Whether a ray from `point` along x crosses the border an odd number of times.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

double distanceToBorder(const Polygon& polygon, const Eigen::Vector2d& point);

double areaOf(const Polygon& polygon);

/// The first two edges that cross, each inside the other; corners and edges that only touch do not.
std::optional<std::pair<std::size_t, std::size_t>> crossingEdges(const Polygon& polygon);

/// A point that lies anywhere in an area, in each part of it as likely as its size.
struct UniformDistribution {
  double area = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// That of a polygon, whose edges do not cross and whose area is not 0. By Green's theorem, with
/// corners p_i, a_i = p_i x p_{i+1} and 2 A = sum a_i:
///   mean = sum a_i (p_i + p_{i+1}) / 6A,
///   E[p p'] = sum a_i (p_i p_i' + p_{i+1} p_{i+1}' + (p_i + p_{i+1})(p_i + p_{i+1})') / 24A.
UniformDistribution uniformDistribution(const Polygon& polygon);

/// That of several areas as one. Where they overlap, a point is as likely as in both together.
UniformDistribution uniformDistribution(const std::vector<UniformDistribution>& parts);

/// Counterclockwise.
using Triangle = std::array<Eigen::Vector2d, 3>;

/// Triangles that cover the polygon, whose edges do not cross, and do not overlap; by clipping ears
/// (Meisters 1975). Edges and corners may touch, as where a corridor goes round a block.
std::vector<Triangle> triangulated(Polygon polygon);

}  // namespace place_recognition
