#pragma once

#include <vector>

#include "simulation/scene.h"

namespace place_recognition::simulation {

struct Hit {
  int facet = -1;            ///< -1: nothing
  float distance = 0.0f;     ///< in lengths of the direction
  float a = 0.0f, b = 0.0f;  ///< m, along the facet's u and v
};

/// Finds what a ray hits, from either side; glass is ignored. Thread-safe. Uses a bounding volume
/// hierarchy, split by the surface area heuristic.
class RayTracer {
 public:
  /// Keeps a reference to the scene.
  explicit RayTracer(const Scene& scene);

  Hit nearest(const Vec3& origin, const Vec3& direction, float reach) const;
  bool blocked(const Vec3& origin, const Vec3& direction, float reach) const;

 private:
  struct Box {
    Vec3 low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};

    void include(const Box& other);
    float area() const;
  };
  struct Node {
    Box box;
    int first = 0;  ///< leaf: index in order_; inner node: left child, followed by its sibling
    int count = 0;  ///< facets in a leaf; 0: inner node
  };
  struct Split {
    int axis = 0, middle = 0;
  };

  void build(int node, int begin, int end);
  Split cheapestSplit(int begin, int end);
  void sortAlong(int axis, int begin, int end);
  template <bool kAny>
  Hit trace(const Vec3& origin, const Vec3& direction, float reach) const;
  bool intersect(int which, const Vec3& origin, const Vec3& direction, Hit& hit) const;

  const Scene& scene_;
  std::vector<Box> boxes_;  ///< of each facet
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace place_recognition::simulation
