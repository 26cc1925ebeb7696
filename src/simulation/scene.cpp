#include "simulation/scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace place_recognition::simulation {
namespace {

constexpr float kPi = 3.14159265f;

/// Sets the frame and the bounding rectangle from the corners.
void measure(Facet& facet) {
  const std::vector<Vec3>& corners = facet.corners;
  facet.normal = cv::normalize((corners[1] - corners[0]).cross(corners[2] - corners[0]));
  const bool flat = std::abs(facet.normal[2]) > 0.9f;
  facet.u = flat ? cv::normalize(corners[1] - corners[0])
                 : cv::normalize(Vec3(0.0f, 0.0f, 1.0f).cross(facet.normal));
  facet.v = -facet.normal.cross(facet.u);

  cv::Vec2f low(1e9f, 1e9f), high(-1e9f, -1e9f);
  for (const Vec3& corner : corners) {
    const cv::Vec2f at(corner.dot(facet.u), corner.dot(facet.v));
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
    }
  }
  facet.origin = low[0] * facet.u + low[1] * facet.v + corners[0].dot(facet.normal) * facet.normal;
  facet.width = high[0] - low[0];
  facet.height = high[1] - low[1];
}

}  // namespace

Vec3 Placement::operator()(float local_x, float local_y, float local_z) const {
  const float c = std::cos(yaw), s = std::sin(yaw);
  return {x + c * local_x - s * local_y, y + s * local_x + c * local_y, z + local_z};
}

Placement Placement::moved(float local_x, float local_y, float local_z, float turn) const {
  const Vec3 to = (*this)(local_x, local_y, local_z);
  return {to[0], to[1], to[2], yaw + turn};
}

int Scene::add(const Material& material) {
  materials.push_back(material);
  return static_cast<int>(materials.size()) - 1;
}

Facet& Scene::polygon(std::vector<Vec3> corners, int material) {
  assert(corners.size() >= 3 && material >= 0);
  Facet facet;
  facet.corners = std::move(corners);
  facet.material = material;
  measure(facet);
  const float area = facet.width * facet.height;
  const std::vector<Vec3>& c = facet.corners;
  facet.rectangle = c.size() == 4 &&
                    std::abs(cv::norm((c[1] - c[0]).cross(c[3] - c[0])) - area) < 1e-4 * area &&
                    std::abs(cv::norm(c[2] - c[1] - c[3] + c[0])) < 1e-4;
  const cv::Size2f size = materials[static_cast<std::size_t>(material)].size;
  if (size.width > 0.0f) {
    facet.repeats = {1.0f / size.width, 1.0f / size.height};
    // Otherwise every board of a shelf would show the same knots.
    const float number = static_cast<float>(facets.size());
    facet.shift = {std::fmod(number * 0.618f, 1.0f), std::fmod(number * 0.382f, 1.0f)};
  } else {
    facet.repeats = {1.0f / facet.width, 1.0f / facet.height};
  }
  facets.push_back(std::move(facet));
  return facets.back();
}

void Scene::box(const Placement& at, const Vec3& low, const Vec3& high, int material) {
  const auto corner = [&](int x, int y, int z) {
    return at(x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]);
  };
  const auto face = [&](int a, int b, int c, int d) {
    std::vector<Vec3> corners;
    for (const int i : {a, b, c, d}) corners.push_back(corner(i & 1, (i >> 1) & 1, i >> 2));
    polygon(std::move(corners), material);
  };
  face(0, 1, 5, 4);  // -y
  face(3, 2, 6, 7);  // +y
  face(2, 0, 4, 6);  // -x
  face(1, 3, 7, 5);  // +x
  face(4, 5, 7, 6);  // top
  if (at.z + low[2] > 0.01f) face(1, 0, 2, 3);
}

Facet& Scene::picture(const Placement& at, float width, float height, int material) {
  const float half = width / 2.0f;
  return polygon({at(-half, 0, 0), at(half, 0, 0), at(half, 0, height), at(-half, 0, height)},
                 material);
}

void Scene::turned(const Placement& at, const Vec3& bottom, const Vec3& top,
                   const std::vector<cv::Vec2f>& half_axes, int material, int sides) {
  const Vec3 axis = cv::normalize(top - bottom);
  const Vec3 hint = std::abs(axis[0]) > 0.8f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 across = cv::normalize(hint - hint.dot(axis) * axis);
  const Vec3 deep = axis.cross(across);
  const auto rings = static_cast<int>(half_axes.size());
  const auto point = [&](int ring, int side) {
    const cv::Vec2f& half = half_axes[static_cast<std::size_t>(ring)];
    const float angle = 2.0f * kPi * static_cast<float>(side % sides) / static_cast<float>(sides);
    const float along = static_cast<float>(ring) / static_cast<float>(std::max(1, rings - 1));
    const Vec3 p = bottom + along * (top - bottom) + std::cos(angle) * half[0] * across +
                   std::sin(angle) * half[1] * deep;
    return at(p[0], p[1], p[2]);
  };
  const auto ring = [&](int which, bool reversed) {
    std::vector<Vec3> corners;
    for (int i = 0; i < sides; ++i) corners.push_back(point(which, reversed ? sides - i : i));
    polygon(std::move(corners), material);
  };
  for (int r = 0; r + 1 < rings; ++r) {
    for (int i = 0; i < sides; ++i) {
      Facet& facet =
          polygon({point(r, i), point(r, i + 1), point(r + 1, i + 1), point(r + 1, i)}, material);
      facet.shift = {static_cast<float>(i) * facet.width * facet.repeats[0], 0.0f};
      facet.bend = 2.0f * std::sin(kPi / static_cast<float>(sides)) * facet.u;
    }
  }
  if (half_axes.back()[0] > 0.005f) ring(rings - 1, false);
  if (half_axes.front()[0] > 0.005f) ring(0, true);
}

}  // namespace place_recognition::simulation
