#pragma once

#include <memory>
#include <vector>

#include <opencv2/core.hpp>

#include "simulation/texture.h"

namespace place_recognition::simulation {

/// The appearance of a surface. Diffuse, except for `mirror`.
struct Material {
  std::shared_ptr<const Texture> texture;
  cv::Size2f size{1.0f, 1.0f};      ///< m per repeat of the texture; empty: once over the facet
  Vec3 tint{1.0f, 1.0f, 1.0f};      ///< factor of the texture; the product is the albedo
  Vec3 emission{0.0f, 0.0f, 0.0f};  ///< radiance; factor of the texture
  float mirror = 0.0f;              ///< fraction of the mirrored scene, at normal incidence
  bool glass = false;               ///< transparent to view and light
};

/// A convex planar polygon.
struct Facet {
  std::vector<Vec3> corners;  ///< m, anticlockwise as seen from the front
  Vec3 origin;                ///< m, a corner of the bounding rectangle
  Vec3 u, v, normal;          ///< unit vectors: right and down as seen from the front; to the front
  float width = 0.0f;         ///< m, of the bounding rectangle, along u
  float height = 0.0f;        ///< m, along v
  Vec3 bend{0.0f, 0.0f, 0.0f};  ///< turn of the normal along u, for a rounded body
  cv::Vec2f repeats;            ///< of the texture per metre, along u and v
  cv::Vec2f shift;              ///< of the texture, in repeats
  int material = 0;
  bool two_sided = false;
  bool rectangle = false;

  Vec3 at(float a, float b) const { return origin + a * u + b * v; }
};

/// A frame for placing things: local x, y, z rotated by yaw about z, then moved.
struct Placement {
  float x = 0.0f, y = 0.0f, z = 0.0f;  ///< m
  float yaw = 0.0f;                    ///< rad

  Vec3 operator()(float local_x, float local_y, float local_z) const;
  Placement moved(float local_x, float local_y, float local_z = 0.0f, float turn = 0.0f) const;
};

/// A luminous rectangle. Without a normal it emits in all directions, like a bulb in a shade.
struct Lamp {
  Vec3 centre;          ///< m
  Vec3 half_u, half_v;  ///< m, from the centre to the middle of two sides
  Vec3 normal;          ///< unit, direction of emission; zero: all directions
  Vec3 radiance;        ///< linear
};

/// The glazed part of an outer wall, which emits like the sky behind it.
using Window = Lamp;

/// All geometry, materials and lights.
class Scene {
 public:
  std::vector<Facet> facets;
  std::vector<Material> materials;
  std::vector<Lamp> lamps;
  std::vector<Window> windows;

  int add(const Material& material);

  /// `corners` as in Facet.
  Facet& polygon(std::vector<Vec3> corners, int material);

  /// From `low` to `high` in the frame of `at`; without a bottom if it stands on the floor.
  void box(const Placement& at, const Vec3& low, const Vec3& high, int material);

  /// An upright rectangle of `width` by `height` facing -y of `at`, with its lower middle there.
  Facet& picture(const Placement& at, float width, float height, int material);

  /// A round body along a line from `bottom` to `top` (in the frame of `at`): half-axes (width,
  /// depth) of the ellipse at equal steps along it.
  void turned(const Placement& at, const Vec3& bottom, const Vec3& top,
              const std::vector<cv::Vec2f>& half_axes, int material, int sides = 12);
};

}  // namespace place_recognition::simulation
