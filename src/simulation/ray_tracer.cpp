#include "simulation/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_recognition::simulation {
namespace {

constexpr int kLeafSize = 4;
constexpr int kDeepest = 128;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Whether a point of the plane lies inside the polygon.
bool contains(const Facet& facet, const Vec3& point) {
  const std::size_t count = facet.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& from = facet.corners[i];
    const Vec3 edge = facet.corners[(i + 1) % count] - from;
    if (edge.cross(point - from).dot(facet.normal) < 0.0f) return false;
  }
  return true;
}

}  // namespace

void RayTracer::Box::include(const Box& other) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

float RayTracer::Box::area() const {
  const Vec3 size = high - low;
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

RayTracer::RayTracer(const Scene& scene) : scene_(scene) {
  for (const Facet& facet : scene.facets) {
    Box box;
    for (const Vec3& corner : facet.corners) box.include({corner, corner});
    if (!scene.materials[index(facet.material)].glass) {
      order_.push_back(static_cast<int>(boxes_.size()));
    }
    boxes_.push_back(box);
  }
  nodes_.emplace_back();
  build(0, 0, static_cast<int>(order_.size()));
}

void RayTracer::build(int node, int begin, int end) {
  Box box;
  for (int i = begin; i < end; ++i) box.include(boxes_[index(order_[index(i)])]);
  nodes_[index(node)] = {box, begin, end - begin};
  if (end - begin <= kLeafSize) return;

  const Split split = cheapestSplit(begin, end);
  sortAlong(split.axis, begin, end);
  const int left = static_cast<int>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[index(node)].first = left;
  nodes_[index(node)].count = 0;
  build(left, begin, split.middle);
  build(left + 1, split.middle, end);
}

void RayTracer::sortAlong(int axis, int begin, int end) {
  std::sort(order_.begin() + begin, order_.begin() + end, [&](int i, int j) {
    const float x = boxes_[index(i)].low[axis] + boxes_[index(i)].high[axis];
    const float y = boxes_[index(j)].low[axis] + boxes_[index(j)].high[axis];
    return x != y ? x < y : i < j;
  });
}

RayTracer::Split RayTracer::cheapestSplit(int begin, int end) {
  Split best;
  float lowest = std::numeric_limits<float>::max();
  std::vector<float> cost(index(end - begin));
  for (int axis = 0; axis < 3; ++axis) {
    sortAlong(axis, begin, end);
    Box right;
    for (int i = end - 1; i > begin; --i) {
      right.include(boxes_[index(order_[index(i)])]);
      cost[index(i - begin)] = right.area() * static_cast<float>(end - i);
    }
    Box left;
    for (int i = begin + 1; i < end; ++i) {
      left.include(boxes_[index(order_[index(i - 1)])]);
      const float total = left.area() * static_cast<float>(i - begin) + cost[index(i - begin)];
      if (total < lowest) {
        lowest = total;
        best = {axis, i};
      }
    }
  }
  return best;
}

bool RayTracer::intersect(int which, const Vec3& origin, const Vec3& direction, Hit& hit) const {
  const Facet& facet = scene_.facets[index(which)];
  const Vec3 offset = origin - facet.origin;
  const float distance = -facet.normal.dot(offset) / facet.normal.dot(direction);
  if (!(distance > 0.0f && distance < hit.distance)) return false;
  const Vec3 at = offset + distance * direction;
  const float a = at.dot(facet.u);
  const float b = at.dot(facet.v);
  if (a < 0.0f || b < 0.0f || a > facet.width || b > facet.height) return false;
  if (!facet.rectangle && !contains(facet, at + facet.origin)) return false;
  hit = {which, distance, a, b};
  return true;
}

template <bool kAny>
Hit RayTracer::trace(const Vec3& origin, const Vec3& direction, float reach) const {
  Hit hit;
  hit.distance = reach;
  const Vec3 inverse(1.0f / direction[0], 1.0f / direction[1], 1.0f / direction[2]);
  int stack[kDeepest];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[index(stack[--size])];
    float enter = 0.0f, leave = hit.distance;
    for (int i = 0; i < 3; ++i) {
      const float t0 = (node.box.low[i] - origin[i]) * inverse[i];
      const float t1 = (node.box.high[i] - origin[i]) * inverse[i];
      enter = std::max(enter, std::min(t0, t1));
      leave = std::min(leave, std::max(t0, t1));
    }
    if (enter > leave) continue;
    if (node.count == 0) {
      const std::size_t left = index(node.first);
      // The nearer child is pushed last, so that it is visited first.
      const Vec3 apart = nodes_[left + 1].box.low + nodes_[left + 1].box.high -
                         nodes_[left].box.low - nodes_[left].box.high;
      const int nearer = apart.dot(direction) > 0.0f ? 0 : 1;
      stack[size++] = node.first + 1 - nearer;
      stack[size++] = node.first + nearer;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const bool met = intersect(order_[index(i)], origin, direction, hit);
      if (kAny && met) return hit;
    }
  }
  return hit;
}

Hit RayTracer::nearest(const Vec3& origin, const Vec3& direction, float reach) const {
  return trace<false>(origin, direction, reach);
}

bool RayTracer::blocked(const Vec3& origin, const Vec3& direction, float reach) const {
  return trace<true>(origin, direction, reach).facet >= 0;
}

}  // namespace place_recognition::simulation
