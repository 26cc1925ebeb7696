#include "labels/polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace place_recognition {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the area of a triangle, positive if it is counterclockwise.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) { return cross(b - a, c - a); }

/// Calls visit(a, b) for each edge of the polygon.
template <typename Visit>
void forEachEdge(const Polygon& polygon, Visit visit) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    visit(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
}

bool edgesCross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Positive if the corners are counterclockwise.
double signedArea(const Polygon& polygon) {
  double twice_area = 0;
  forEachEdge(polygon, [&, origin = polygon.front()](const Vector2d& a, const Vector2d& b) {
    twice_area += turn(origin, a, b);
  });
  return twice_area / 2;
}

/// A smaller turn, for corners as far apart as these, is due to rounding.
double roundingOf(const Polygon& polygon) {
  double size = 0;
  for (const Vector2d& corner : polygon) {
    size = std::max(size, (corner - polygon.front()).squaredNorm());
  }
  return 1e-12 * size;
}

Triangle triangleAt(const Polygon& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  return {polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]};
}

/// Whether no other corner is in the counterclockwise triangle or on its border.
bool isEmpty(const Triangle& triangle, const Polygon& polygon) {
  const auto& [a, b, c] = triangle;
  for (const Vector2d& corner : polygon) {
    if (corner == a || corner == b || corner == c) continue;
    if (turn(a, b, corner) >= 0 && turn(b, c, corner) >= 0 && turn(c, a, corner) >= 0) return false;
  }
  return true;
}

}  // namespace

bool contains(const Polygon& polygon, const Vector2d& point) {
  bool inside = false;
  forEachEdge(polygon, [&](const Vector2d& a, const Vector2d& b) {
    if ((a.y() > point.y()) == (b.y() > point.y())) return;
    const double fraction = (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < a.x() + fraction * (b.x() - a.x())) inside = !inside;
  });
  return inside;
}

double distanceToBorder(const Polygon& polygon, const Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  forEachEdge(polygon, [&](const Vector2d& a, const Vector2d& b) {
    const Vector2d edge = b - a;
    const double length = edge.squaredNorm();
    const double fraction = length > 0 ? std::clamp((point - a).dot(edge) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + fraction * edge - point).norm());
  });
  return nearest;
}

double areaOf(const Polygon& polygon) { return std::abs(signedArea(polygon)); }

std::optional<std::pair<std::size_t, std::size_t>> crossingEdges(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (edgesCross(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n])) {
        return std::make_pair(i, j);
      }
    }
  }
  return std::nullopt;
}

UniformDistribution uniformDistribution(const Polygon& polygon) {
  const Vector2d origin = polygon.front();  // far from it, digits would be lost
  double twice_area = 0;
  Vector2d first = Vector2d::Zero();
  Matrix2d second = Matrix2d::Zero();
  forEachEdge(polygon, [&](const Vector2d& a, const Vector2d& b) {
    const Vector2d p = a - origin;
    const Vector2d q = b - origin;
    const Vector2d sum = p + q;
    const double weight = cross(p, q);
    twice_area += weight;
    first += weight * sum;
    second += weight * (p * p.transpose() + q * q.transpose() + sum * sum.transpose());
  });
  assert(twice_area != 0);
  const Vector2d mean = first / (3 * twice_area);
  return {std::abs(twice_area) / 2, origin + mean,
          second / (12 * twice_area) - mean * mean.transpose()};
}

UniformDistribution uniformDistribution(const std::vector<UniformDistribution>& parts) {
  UniformDistribution whole;
  for (const UniformDistribution& part : parts) whole.area += part.area;
  assert(whole.area > 0);
  for (const UniformDistribution& part : parts) whole.mean += part.area / whole.area * part.mean;
  for (const UniformDistribution& part : parts) {
    const Vector2d offset = part.mean - whole.mean;
    whole.covariance += part.area / whole.area * (part.covariance + offset * offset.transpose());
  }
  return whole;
}

std::vector<Triangle> triangulated(Polygon polygon) {
  if (signedArea(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  const double rounding = roundingOf(polygon);
  std::vector<Triangle> triangles;
  // Without crossings there is always a corner to clip; otherwise the search ends when all were
  // tried.
  for (std::size_t i = 0, tried = 0; polygon.size() >= 3 && tried < polygon.size();) {
    const Triangle corner = triangleAt(polygon, i);
    const double area = turn(corner[0], corner[1], corner[2]);
    const bool flat = std::abs(area) <= rounding;
    if (flat || (area > 0 && isEmpty(corner, polygon))) {
      if (!flat) triangles.push_back(corner);
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
      tried = 0;
    } else {
      ++i;
      ++tried;
    }
    if (i >= polygon.size()) i = 0;
  }
  return triangles;
}

}  // namespace place_recognition
