#pragma once

#include <opencv2/core.hpp>

#include "simulation/renderer.h"

namespace place_recognition::simulation {

/// The ring that a mirror shows in an image.
struct MirrorRing {
  cv::Point2f center;  ///< pixels
  float inner = 0.0f;  ///< px; nearer to the centre the mirror shows the camera itself
  float outer = 0.0f;  ///< px; the mirror's rim
};

/// Where the mirror is in images of that size: a little off their middle.
MirrorRing mirrorRing(cv::Size size);

/// Draws a scene as an omnidirectional camera sees it, which looks up into a hyperbolic mirror: all
/// directions around, from 45 degrees below the horizon to 25 above, those ahead at the top of the
/// image, those to the left at its right. The sphere model of Geyer and Daniilidis (2000): a
/// direction at the angle phi from straight down is seen at the radius
///   r = g sin(phi) / (xi + cos(phi)).
/// Thread-safe.
class OmniRenderer {
 public:
  /// Keeps references to all three.
  OmniRenderer(const Scene& scene, const RayTracer& tracer, const Lighting& lighting,
               cv::Size size);

  /// As Renderer::render(); dark outside of the ring.
  cv::Mat render(const View& view) const;

 private:
  cv::Size size_;
  float focal_;     ///< of the four pinhole cameras that together see all around, px
  Renderer faces_;  ///< one for the four
  cv::Mat map_;     ///< CV_32FC2: where in their images, side by side, a pixel is seen
};

}  // namespace place_recognition::simulation
