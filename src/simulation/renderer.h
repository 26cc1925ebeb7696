#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "simulation/camera.h"
#include "simulation/lighting.h"
#include "simulation/ray_tracer.h"
#include "simulation/scene.h"

namespace place_recognition::simulation {

/// Renders a lit scene with a pinhole camera: polygons are rasterized into a depth buffer with 2 x
/// 2 samples per pixel, then each visible sample is shaded once. Mirrors and glass use the ray
/// tracer. The centre of the upper left pixel is (0.5, 0.5). Thread-safe.
class Renderer {
 public:
  /// Keeps references to all three. `focal`: in pixels of the image.
  Renderer(const Scene& scene, const RayTracer& tracer, const Lighting& lighting, cv::Size size,
           float focal);

  /// The radiance of each pixel: CV_32FC3, linear, BGR.
  cv::Mat render(const View& view) const;

 private:
  struct Frame;

  void project(Frame& frame, int facet) const;
  void scan(Frame& frame, int facet, const std::vector<cv::Vec2f>& outline, bool glass) const;
  Vec3 pixel(const Frame& frame, int x, int y) const;
  Vec3 sample(const Frame& frame, int facet, int glass, float x, float y, float extent) const;
  Vec3 shade(const Frame& frame, int facet, float x, float y, float extent) const;
  Vec3 surface(int facet, float a, float b, float extent_a, float extent_b) const;
  Vec3 mirrored(const Vec3& point, const Vec3& direction, const Vec3& normal, float step) const;

  const Scene& scene_;
  const RayTracer& tracer_;
  const Lighting& lighting_;
  cv::Size samples_;  ///< twice the size of the image
  float focal_;       ///< in samples
};

}  // namespace place_recognition::simulation
