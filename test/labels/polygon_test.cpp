// Polygons: moments against formulas and a fine grid, and triangulations that cover the polygon.

#include "labels/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace place_recognition {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

Polygon rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Matrix2d matrix(double xx, double xy, double yy) {
  Matrix2d values;
  values << xx, xy, xy, yy;
  return values;
}

/// Returns corners at equal angles around the origin.
Polygon regular(int corners, double radius) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

/// Returns a star with that many corners at random distances from the origin.
Polygon star(int corners, unsigned seed) {
  std::mt19937 random(seed);
  Polygon polygon = regular(corners, 1);
  for (Vector2d& corner : polygon) corner *= 0.3 + static_cast<double>(random() % 1000) / 250;
  return polygon;
}

struct Shape {
  std::string name;
  Polygon polygon;
};

/// Shapes of rooms, typical and unusual.
std::vector<Shape> shapes() {
  std::vector<Shape> all = {
      {"Triangle", {{0, 0}, {3, 0}, {1, 2}}},
      {"Rectangle", rectangle(1, 2, 4, 3)},
      {"L", {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}}},
      {"U", {{0, 0}, {7, 0}, {7, 5}, {5, 5}, {5, 2}, {2, 2}, {2, 5}, {0, 5}}},
      {"Comb",
       {{0, 0}, {9, 0}, {9, 4}, {8, 1}, {7, 4}, {6, 1}, {5, 4}, {4, 1}, {3, 4}, {2, 1}, {1, 4}}},
      {"Spiral",
       {{0, 0},
        {6, 0},
        {6, 6},
        {1, 6},
        {1, 2},
        {4, 2},
        {4, 4},
        {3, 4},
        {3, 3},
        {2, 3},
        {2, 5},
        {5, 5},
        {5, 1},
        {0, 1}}},
      {"CornersOnWalls", {{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 3}, {2, 3}, {0, 3}, {0, 2}}},
      // A corridor around a block, joined to its inner wall by an edge that is traversed twice.
      {"Ring", {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}},
      {"FarAway", rectangle(5e5, 4e6, 4, 3)},
  };
  for (unsigned seed = 0; seed < 20; ++seed) {
    all.push_back({"Star" + std::to_string(seed), star(5 + static_cast<int>(seed), seed)});
  }
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {  // each starting at another corner, in reverse order
    Polygon turned = all[i].polygon;
    std::rotate(turned.begin(), turned.begin() + 2, turned.end());
    std::reverse(turned.begin(), turned.end());
    all.push_back({all[i].name + "Clockwise", turned});
  }
  return all;
}

std::string nameOf(const testing::TestParamInfo<Shape>& info) { return info.param.name; }

class Shapes : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(shapes()), nameOf);

/// Computes the moments from the points of a fine grid that lie in the polygon.
UniformDistribution counted(const Polygon& polygon) {
  constexpr int kSteps = 400;
  Vector2d low = polygon.front();
  Vector2d high = low;
  for (const Vector2d& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vector2d step = (high - low) / kSteps;
  double count = 0;
  Vector2d first = Vector2d::Zero();
  Matrix2d second = Matrix2d::Zero();
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Vector2d offset = step.cwiseProduct(Vector2d(i + 0.5, j + 0.5));
      if (!contains(polygon, low + offset)) continue;
      ++count;
      first += offset;
      second += offset * offset.transpose();
    }
  }
  const Vector2d mean = first / count;
  return {count * step.prod(), low + mean, second / count - mean * mean.transpose()};
}

TEST_P(Shapes, HaveTheMomentsThatAreCounted) {
  const UniformDistribution exact = uniformDistribution(GetParam().polygon);
  const UniformDistribution expected = counted(GetParam().polygon);
  EXPECT_NEAR(exact.area, expected.area, 0.01 * exact.area);
  EXPECT_EQ(exact.area, areaOf(GetParam().polygon));
  const double size = exact.covariance.trace();
  EXPECT_LT((exact.mean - expected.mean).norm(), 0.01 * std::sqrt(size));
  EXPECT_LT((exact.covariance - expected.covariance).norm(), 0.02 * size);
}

TEST_P(Shapes, AreCoveredByTrianglesThatDoNotOverlap) {
  const Polygon& polygon = GetParam().polygon;
  const std::vector<Triangle> triangles = triangulated(polygon);
  EXPECT_LE(triangles.size(), polygon.size() - 2);
  std::vector<UniformDistribution> parts;
  std::vector<Polygon> outlines;
  for (const Triangle& triangle : triangles) {
    outlines.push_back({triangle[0], triangle[1], triangle[2]});
    parts.push_back(uniformDistribution(outlines.back()));
    const Vector2d side = triangle[1] - triangle[0];
    const Vector2d other = triangle[2] - triangle[0];
    EXPECT_GT(side.x() * other.y() - side.y() * other.x(), 0);  // counterclockwise
    EXPECT_TRUE(contains(polygon, parts.back().mean));
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t j = 0; j < outlines.size(); ++j) {
      EXPECT_EQ(contains(outlines[i], parts[j].mean), i == j);
    }
  }
  const UniformDistribution expected = uniformDistribution(polygon);
  const UniformDistribution together = uniformDistribution(parts);
  EXPECT_NEAR(together.area, expected.area, 1e-9 * expected.area);
  EXPECT_LT((together.mean - expected.mean).norm(), 1e-9 * (1 + expected.mean.norm()));
  EXPECT_LT((together.covariance - expected.covariance).norm(), 1e-7 * expected.area);
}

TEST_P(Shapes, HaveNoEdgesThatCross) { EXPECT_FALSE(crossingEdges(GetParam().polygon)); }

TEST(Moments, OfARectangleAreATwelfthOfItsSidesSquared) {
  const UniformDistribution room = uniformDistribution(rectangle(-1, 2, 6, 3));
  EXPECT_DOUBLE_EQ(room.area, 18);
  EXPECT_LT((room.mean - Vector2d(2, 3.5)).norm(), 1e-12);
  EXPECT_LT((room.covariance - matrix(3, 0, 0.75)).norm(), 1e-12);
}

TEST(Moments, OfARightTriangle) {
  const UniformDistribution room = uniformDistribution(Polygon{{0, 0}, {6, 0}, {0, 3}});
  EXPECT_DOUBLE_EQ(room.area, 9);
  EXPECT_LT((room.mean - Vector2d(2, 1)).norm(), 1e-12);
  EXPECT_LT((room.covariance - matrix(36. / 18, -18. / 36, 9. / 18)).norm(), 1e-12);
}

TEST(Moments, OfARegularPolygonAreTheSameInAllDirections) {
  for (const int n : {3, 4, 5, 6, 17, 100}) {
    const UniformDistribution room = uniformDistribution(regular(n, 2));
    EXPECT_NEAR(room.area, n * 2 * std::sin(2 * M_PI / n), 1e-9);
    EXPECT_LT(room.mean.norm(), 1e-9);
    const double variance = 4 * (2 + std::cos(2 * M_PI / n)) / 12;
    EXPECT_LT((room.covariance - variance * Matrix2d::Identity()).norm(), 1e-9) << n;
  }
}

TEST(Moments, AreAsExactFarFromTheOriginOfTheMap) {
  const UniformDistribution room = uniformDistribution(rectangle(691607.3, 5335800.1, 5, 4));
  EXPECT_LT((room.covariance - matrix(25. / 12, 0, 16. / 12)).norm(), 1e-7);
  EXPECT_NEAR(room.mean.y(), 5335802.1, 1e-6);
}

TEST(Moments, TurnWithTheRoom) {
  Matrix2d turn;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  const Polygon room = star(12, 99);
  Polygon turned;
  for (const Vector2d& corner : room) turned.emplace_back(turn * corner);
  const UniformDistribution a = uniformDistribution(room);
  const UniformDistribution b = uniformDistribution(turned);
  EXPECT_NEAR(a.area, b.area, 1e-9);
  EXPECT_LT((turn * a.mean - b.mean).norm(), 1e-9);
  EXPECT_LT((turn * a.covariance * turn.transpose() - b.covariance).norm(), 1e-9);
}

TEST(Moments, OfPartsAreThoseOfTheWhole) {
  const UniformDistribution whole =
      uniformDistribution(Polygon{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}});
  const UniformDistribution joined = uniformDistribution(
      {uniformDistribution(rectangle(0, 0, 6, 2)), uniformDistribution(rectangle(0, 2, 2, 4))});
  EXPECT_NEAR(joined.area, whole.area, 1e-12);
  EXPECT_LT((joined.mean - whole.mean).norm(), 1e-12);
  EXPECT_LT((joined.covariance - whole.covariance).norm(), 1e-12);
  // Two rooms with one name, 10 m apart: most of the variance is between them.
  const UniformDistribution apart = uniformDistribution(
      {uniformDistribution(rectangle(0, 0, 2, 2)), uniformDistribution(rectangle(10, 0, 2, 2))});
  EXPECT_LT((apart.mean - Vector2d(6, 1)).norm(), 1e-12);
  EXPECT_LT((apart.covariance - matrix(4. / 12 + 25, 0, 4. / 12)).norm(), 1e-12);
}

TEST(CrossingEdges, AreNamedByTheirFirstCorners) {
  const auto edges = crossingEdges({{0, 0}, {4, 0}, {0, 3}, {4, 3}});
  ASSERT_TRUE(edges);
  EXPECT_EQ(edges->first, 1u);
  EXPECT_EQ(edges->second, 3u);
}

TEST(Triangles, OfADrawnCombAreAsManyAsItHasCornersLessTwo) {
  for (const int teeth : {1, 2, 10, 200}) {
    Polygon comb = {{0, 0}, {2.0 * teeth, 0}};
    for (int i = teeth; i > 0; --i) {
      comb.emplace_back(2 * i - 0.5, 3);
      comb.emplace_back(2 * i - 1.5, 1);
    }
    EXPECT_EQ(triangulated(comb).size(), comb.size() - 2);
  }
}

TEST(Triangles, OfInvalidPolygonsTerminate) {
  EXPECT_TRUE(triangulated({{0, 0}, {1, 1}, {2, 2}}).empty());
  EXPECT_LE(triangulated({{0, 0}, {4, 0}, {0, 3}, {4, 3}}).size(), 2u);
}

}  // namespace
}  // namespace place_recognition
