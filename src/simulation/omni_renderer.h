#pragma once

#include <opencv2/core.hpp>

#include "simulation/renderer.h"

namespace place_recognition::simulation {

/// The ring in which a mirror appears in an image.
struct MirrorRing {
  cv::Point2f center;  ///< pixels
  float inner = 0.0f;  ///< px; closer to the centre the mirror shows the camera itself
  float outer = 0.0f;  ///< px; the mirror's rim
};

/// The ring of the mirror in images of that size; it is slightly off-centre.
MirrorRing mirrorRing(cv::Size size);

/// Renders a scene for an omnidirectional camera that looks up into a hyperbolic mirror: all
/// azimuths, from 45 degrees below the horizon to 25 above; forward is at the top of the image, and
/// left at its right. Uses the sphere model of Geyer and Daniilidis (2000): a direction at the
/// angle phi from straight down appears at the radius
///   r = g sin(phi) / (xi + cos(phi)).
/// Thread-safe.
class OmniRenderer {
 public:
  /// Keeps references to all three.
  OmniRenderer(const Scene& scene, const RayTracer& tracer, const Lighting& lighting,
               cv::Size size);

  /// Like Renderer::render(); dark outside of the ring.
  cv::Mat render(const View& view) const;

 private:
  cv::Size size_;
  float focal_;     ///< px, of the four pinhole cameras that together cover all azimuths
  Renderer faces_;  ///< one for all four
  cv::Mat map_;     ///< CV_32FC2: position of each pixel in their images, side by side
};

}  // namespace place_recognition::simulation
