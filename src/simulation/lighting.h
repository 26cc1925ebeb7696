#pragma once

#include <vector>

#include "simulation/light.h"
#include "simulation/ray_tracer.h"
#include "simulation/scene.h"

namespace place_recognition::simulation {

/// The light on every surface, computed once for a static scene: from lamps, windows and
/// reflections between surfaces on a coarse grid; from the sun, whose patches have sharp borders,
/// on a fine grid. Thread-safe once built; the result does not depend on the number of threads.
class Lighting {
 public:
  /// `spacing`: m, of the coarse grid. Keeps references to scene and tracer.
  Lighting(const Scene& scene, const RayTracer& tracer, const Daylight& daylight, float spacing,
           unsigned threads);

  /// Irradiance of the front of a facet at (a, b) m along its u and v; linear.
  Vec3 irradiance(int facet, float a, float b) const;

 private:
  /// Values at the nodes of a grid that spans a facet; empty: zero everywhere.
  template <typename Value>
  struct Grid {
    int columns = 0, rows = 0;
    std::vector<Value> values;

    Grid() = default;
    Grid(const Facet& facet, float spacing);
    Value at(const Facet& facet, float a, float b) const;
  };

  Vec3 direct(const Vec3& point, const Vec3& normal) const;
  Vec3 fromLamp(const Lamp& lamp, const Vec3& point, const Vec3& normal, bool window) const;
  Vec3 bounced(const Vec3& point, const Vec3& normal) const;
  /// Replaces soft_ by `first`, the direct light of the lamps, plus what soft_ reflects.
  void addBounce(const std::vector<Grid<Vec3>>& first, float spacing, unsigned threads);
  void bakeSun(std::size_t facet, float spacing);

  /// Fills one grid per facet with `value(point, normal)`.
  template <typename Function>
  std::vector<Grid<Vec3>> bake(float spacing, unsigned threads, const Function& value) const;

  const Scene& scene_;
  const RayTracer& tracer_;
  Daylight daylight_;
  std::vector<Vec3> albedo_;        ///< average of each material
  std::vector<Grid<Vec3>> soft_;    ///< of each facet
  std::vector<Grid<float>> sunny_;  ///< of each facet: the cosine towards the sun where it shines
};

}  // namespace place_recognition::simulation
