#pragma once

#include <memory>
#include <vector>

#include <opencv2/core.hpp>

#include "simulation/texture.h"

namespace place_recognition::simulation {

/// What a surface looks like. Diffuse, but for `mirror`.
struct Material {
  std::shared_ptr<const Texture> texture;
  cv::Size2f size{1.0f, 1.0f};      ///< m a repeat of the texture; empty: once over the facet
  Vec3 tint{1.0f, 1.0f, 1.0f};      ///< multiplies the texture; times it, the albedo
  Vec3 emission{0.0f, 0.0f, 0.0f};  ///< radiance; multiplies the texture
  float mirror = 0.0f;              ///< fraction of the mirrored scene, at normal incidence
  bool glass = false;               ///< seen through, and shines through
};

/// A convex planar polygon.
struct Facet {
  std::vector<Vec3> corners;  ///< m, anticlockwise as seen from the front
  Vec3 origin;                ///< m, a corner of the bounding rectangle
  Vec3 u, v, normal;          ///< unit vectors: right and down as seen from the front; to the front
  float width = 0.0f;         ///< m, of the bounding rectangle, along u
  float height = 0.0f;        ///< m, along v
  Vec3 bend{0.0f, 0.0f, 0.0f};  ///< by how much the normal of a rounded body turns along u
  cv::Vec2f repeats;            ///< of the texture a metre, along u and v
  cv::Vec2f shift;              ///< of the texture, in repeats
  int material = 0;
  bool two_sided = false;
  bool rectangle = false;

  Vec3 at(float a, float b) const { return origin + a * u + b * v; }
};

/// A place to stand things at: local x, y, z turned by yaw about z, then moved.
struct Placement {
  float x = 0.0f, y = 0.0f, z = 0.0f;  ///< m
  float yaw = 0.0f;                    ///< rad

  Vec3 operator()(float local_x, float local_y, float local_z) const;
  Placement moved(float local_x, float local_y, float local_z = 0.0f, float turn = 0.0f) const;
};

/// A luminous rectangle. Without a normal it shines to all sides, as a bulb in a shade.
struct Lamp {
  Vec3 centre;          ///< m
  Vec3 half_u, half_v;  ///< m, from the centre to the middle of two sides
  Vec3 normal;          ///< unit, where it shines; zero: everywhere
  Vec3 radiance;        ///< linear
};

/// The glazed part of an outer wall. It shines as the sky behind it does.
using Window = Lamp;

/// Everything that is in front of the camera.
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

  /// An upright rectangle `width` by `height` that faces -y of `at`, its lower middle there.
  Facet& picture(const Placement& at, float width, float height, int material);

  /// A round body along a line from `bottom` to `top` (in the frame of `at`): half axes (across,
  /// deep) of the ellipse at equal steps along it.
  void turned(const Placement& at, const Vec3& bottom, const Vec3& top,
              const std::vector<cv::Vec2f>& half_axes, int material, int sides = 12);
};

}  // namespace place_recognition::simulation
