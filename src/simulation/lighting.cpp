#include "simulation/lighting.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "simulation/random.h"

namespace place_recognition::simulation {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kLift = 0.003f;   ///< m, distance from a surface at which a ray starts
constexpr float kInset = 0.015f;  ///< m, inset of the outer nodes, so that they see past the corner
constexpr float kSampleStep = 0.5f;  ///< m, spacing of the points that represent a lamp's area
constexpr int kStrata = 6;  ///< its square is the number of rays that gather reflected light
constexpr float kFarthest = 25.0f;  ///< m, size of the building; the outdoors is farther

float nodePosition(int i, int count, float length) {
  if (count == 1) return length / 2.0f;
  const float inset = std::min(kInset, length / 4.0f);
  return inset + (length - 2.0f * inset) * static_cast<float>(i) / static_cast<float>(count - 1);
}

int nodeCount(float length, float spacing) {
  return length < spacing / 2.0f ? 1 : 2 + static_cast<int>(length / spacing);
}

/// The normal of a rounded body at `a` metres along u.
Vec3 normalAt(const Facet& facet, float a) {
  return cv::normalize(facet.normal + (a / facet.width - 0.5f) * facet.bend);
}

/// Removes most of the noise that few rays leave in a grid of reflected light.
template <typename Grid>
void smooth(Grid& grid) {
  const Grid source = grid;
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      Vec3 sum;
      float count = 0.0f;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, grid.rows - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, grid.columns - 1); ++u) {
          sum += source.values[static_cast<std::size_t>(v * grid.columns + u)];
          count += 1.0f;
        }
      }
      grid.values[static_cast<std::size_t>(y * grid.columns + x)] = sum / count;
    }
  }
}

}  // namespace

template <typename Value>
Lighting::Grid<Value>::Grid(const Facet& facet, float spacing)
    : columns(nodeCount(facet.width, spacing)), rows(nodeCount(facet.height, spacing)) {
  values.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

template <typename Value>
Value Lighting::Grid<Value>::at(const Facet& facet, float a, float b) const {
  if (values.empty()) return Value();
  const float x = std::clamp(a / facet.width, 0.0f, 1.0f) * static_cast<float>(columns - 1);
  const float y = std::clamp(b / facet.height, 0.0f, 1.0f) * static_cast<float>(rows - 1);
  const int x0 = std::min(static_cast<int>(x), std::max(columns - 2, 0));
  const int y0 = std::min(static_cast<int>(y), std::max(rows - 2, 0));
  const float wx = x - static_cast<float>(x0);
  const float wy = y - static_cast<float>(y0);
  const int right = columns > 1 ? 1 : 0;
  const Value* upper = &values[static_cast<std::size_t>(y0 * columns + x0)];
  const Value* lower = rows > 1 ? upper + columns : upper;
  return (1.0f - wy) * ((1.0f - wx) * upper[0] + wx * upper[right]) +
         wy * ((1.0f - wx) * lower[0] + wx * lower[right]);
}

template <typename Function>
std::vector<Lighting::Grid<Vec3>> Lighting::bake(float spacing, unsigned threads,
                                                 const Function& value) const {
  std::vector<Grid<Vec3>> grids(scene_.facets.size());
  parallelFor(grids.size(), threads, [&](std::size_t i, unsigned) {
    const Facet& facet = scene_.facets[i];
    const Material& material = scene_.materials[static_cast<std::size_t>(facet.material)];
    if (material.glass) return;
    Grid<Vec3> grid(facet, spacing);
    std::size_t node = 0;
    for (int y = 0; y < grid.rows; ++y) {
      for (int x = 0; x < grid.columns; ++x, ++node) {
        const float a = nodePosition(x, grid.columns, facet.width);
        const Vec3 point = facet.at(a, nodePosition(y, grid.rows, facet.height));
        const Vec3 normal = normalAt(facet, a);
        grid.values[node] = value(point + kLift * facet.normal, normal);
        if (facet.two_sided) {  // thin, hence lit through
          const Vec3 behind = value(point - kLift * facet.normal, -normal);
          grid.values[node] = 0.5f * (grid.values[node] + behind);
        }
      }
    }
    grids[i] = std::move(grid);
  });
  return grids;
}

Lighting::Lighting(const Scene& scene, const RayTracer& tracer, const Daylight& daylight,
                   float spacing, unsigned threads)
    : scene_(scene), tracer_(tracer), daylight_(daylight), sunny_(scene.facets.size()) {
  for (const Material& material : scene.materials) {
    albedo_.push_back(material.tint.mul(material.texture->average()));
  }
  if (daylight_.sun[1] > 0.0f) {
    parallelFor(scene.facets.size(), threads,
                [&](std::size_t i, unsigned) { bakeSun(i, spacing / 4.0f); });
  }
  const std::vector<Grid<Vec3>> first =
      bake(spacing, threads,
           [&](const Vec3& point, const Vec3& normal) { return direct(point, normal); });
  soft_ = first;
  addBounce(first, spacing, threads);
  addBounce(first, spacing, threads);
}

void Lighting::addBounce(const std::vector<Grid<Vec3>>& first, float spacing, unsigned threads) {
  std::vector<Grid<Vec3>> bounce =
      bake(3.0f * spacing, threads,
           [&](const Vec3& point, const Vec3& normal) { return bounced(point, normal); });
  soft_ = first;
  parallelFor(bounce.size(), threads, [&](std::size_t i, unsigned) {
    if (bounce[i].values.empty()) return;
    smooth(bounce[i]);
    const Facet& facet = scene_.facets[i];
    Grid<Vec3>& sum = soft_[i];
    for (int y = 0; y < sum.rows; ++y) {
      for (int x = 0; x < sum.columns; ++x) {
        sum.values[static_cast<std::size_t>(y * sum.columns + x)] +=
            bounce[i].at(facet, nodePosition(x, sum.columns, facet.width),
                         nodePosition(y, sum.rows, facet.height));
      }
    }
  });
}

Vec3 Lighting::irradiance(int facet, float a, float b) const {
  const auto i = static_cast<std::size_t>(facet);
  const Facet& surface = scene_.facets[i];
  Vec3 result = soft_[i].at(surface, a, b);
  if (!sunny_[i].values.empty()) result += sunny_[i].at(surface, a, b) * daylight_.sun;
  return result;
}

Vec3 Lighting::direct(const Vec3& point, const Vec3& normal) const {
  Vec3 sum;
  for (const Lamp& lamp : scene_.lamps) sum += fromLamp(lamp, point, normal, false);
  for (const Window& window : scene_.windows) sum += fromLamp(window, point, normal, true);
  return sum;
}

Vec3 Lighting::fromLamp(const Lamp& lamp, const Vec3& point, const Vec3& normal,
                        bool window) const {
  const float half_u = static_cast<float>(cv::norm(lamp.half_u));
  const float half_v = static_cast<float>(cv::norm(lamp.half_v));
  const int columns = std::max(1, static_cast<int>(2.0f * half_u / kSampleStep + 0.5f));
  const int rows = std::max(1, static_cast<int>(2.0f * half_v / kSampleStep + 0.5f));
  const float area = 4.0f * half_u * half_v / static_cast<float>(columns * rows);
  const bool everywhere = lamp.normal.dot(lamp.normal) == 0.0f;
  const Vec3& radiance = window ? daylight_.sky : lamp.radiance;
  Vec3 sum;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float s = 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 1.0f;
      const float t = 2.0f * (static_cast<float>(j) + 0.5f) / static_cast<float>(rows) - 1.0f;
      const Vec3 source = lamp.centre + s * lamp.half_u + t * lamp.half_v + 0.01f * lamp.normal;
      const Vec3 way = source - point;
      const float squared = way.dot(way);
      const float distance = std::sqrt(squared);
      const float here = normal.dot(way) / distance;
      const float there = everywhere ? 1.0f : -lamp.normal.dot(way) / distance;
      if (here <= 0.0f || there <= 0.0f) continue;
      float fraction = here * there * area / std::max(squared, 0.5f * area);
      if (fraction * radiance[1] < 0.004f) continue;
      // A fabric shade would shadow its own centre.
      if (tracer_.blocked(point, way,
                          everywhere ? 1.0f - 0.21f / std::max(distance, 0.3f) : 1.0f)) {
        continue;
      }
      // Looking up through a window one sees the sky; looking down, the darker ground.
      if (window) fraction *= 0.9f + 0.8f * std::clamp(way[2] / distance, -0.7f, 0.7f);
      sum += fraction * radiance;
    }
  }
  return sum;
}

Vec3 Lighting::bounced(const Vec3& point, const Vec3& normal) const {
  // The same rays for every node, so that neighbours agree; independent noise would not.
  Random random(77);
  const Vec3 hint = std::abs(normal[2]) > 0.7f ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  const Vec3 across = cv::normalize(hint.cross(normal));
  const Vec3 along = normal.cross(across);
  Vec3 sum;
  for (int i = 0; i < kStrata; ++i) {
    for (int j = 0; j < kStrata; ++j) {
      // Density proportional to the cosine, so that each ray has the same weight.
      const float square = (static_cast<float>(i) + random.uniform()) / kStrata;
      const float angle = 2.0f * kPi * (static_cast<float>(j) + random.uniform()) / kStrata;
      const float radius = std::sqrt(square);
      const Vec3 direction = radius * std::cos(angle) * across + radius * std::sin(angle) * along +
                             std::sqrt(1.0f - square) * normal;
      const Hit hit = tracer_.nearest(point, direction, kFarthest);
      if (hit.facet < 0) continue;
      const Facet& facet = scene_.facets[static_cast<std::size_t>(hit.facet)];
      if (!facet.two_sided && facet.normal.dot(direction) > 0.0f) continue;
      sum += albedo_[static_cast<std::size_t>(facet.material)].mul(
          irradiance(hit.facet, hit.a, hit.b));
    }
  }
  return sum / static_cast<float>(kStrata * kStrata);
}

void Lighting::bakeSun(std::size_t index, float spacing) {
  const Facet& facet = scene_.facets[index];
  const float cosine = facet.normal.dot(daylight_.to_sun);
  if (cosine <= 0.0f && !facet.two_sided && facet.bend == Vec3(0, 0, 0)) return;
  const Vec3 lift = kLift * (cosine < 0.0f ? -facet.normal : facet.normal);
  Grid<float> grid(facet, spacing);
  bool shines = false;
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      const float a = nodePosition(x, grid.columns, facet.width);
      const float b = nodePosition(y, grid.rows, facet.height);
      float facing = normalAt(facet, a).dot(daylight_.to_sun);
      if (facet.two_sided) facing = 0.5f * std::abs(facing);
      if (facing <= 0.0f) continue;
      int lit = 0;  // of four points around the node, for a soft border
      for (int i = 0; i < 4; ++i) {
        const float u = a + spacing * (static_cast<float>(i & 1) - 0.5f) / 2.0f;
        const float v = b + spacing * (static_cast<float>(i >> 1) - 0.5f) / 2.0f;
        const Vec3 point =
            facet.at(std::clamp(u, 0.0f, facet.width), std::clamp(v, 0.0f, facet.height));
        lit += tracer_.blocked(point + lift, daylight_.to_sun, kFarthest) ? 0 : 1;
      }
      grid.values[static_cast<std::size_t>(y * grid.columns + x)] =
          facing * static_cast<float>(lit) / 4.0f;
      shines = shines || lit > 0;
    }
  }
  if (shines) sunny_[index] = std::move(grid);
}

}  // namespace place_recognition::simulation
