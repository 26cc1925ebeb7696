#include "simulation/omni_renderer.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace place_recognition::simulation {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kXi = 0.95f;            ///< a hyperbola's; 1 is a parabola
constexpr float kLowest = 0.25f * kPi;  ///< rad from straight down
constexpr float kHighest = 115 * kPi / 180;
constexpr float kRim = 0.47f;               ///< radius of the mirror, in shorter sides of the image
const Vec3 kSurround(0.02f, 0.02f, 0.02f);  ///< radiance beside the mirror, and of the camera in it
constexpr int kFaces = 4;
/// Width of a face, in focal lengths: a quarter of the circle, with a margin for interpolation.
constexpr float kFaceWidth = 2.05f;
/// Where the lowest directions at 45 degrees to a face's centre leave the face.
const float kFaceHeight = 2.05f / std::cos(0.25f * kPi);

/// The radius of a direction at `angle` from straight down, in units of g.
float radiusAt(float angle) { return std::sin(angle) / (kXi + std::cos(angle)); }

float scaleOf(cv::Size size) { return mirrorRing(size).outer / radiusAt(kHighest); }

cv::Size faceSize(float focal) {
  return {2 * static_cast<int>(std::ceil(0.5f * kFaceWidth * focal)),
          2 * static_cast<int>(std::ceil(0.5f * kFaceHeight * focal))};
}

/// Position on the faces of the pixel at `offset` from the mirror's centre; behind them: nowhere.
cv::Vec2f onFaces(cv::Point2f offset, float scale, float focal) {
  const float radius = std::hypot(offset.x, offset.y) / scale;
  if (radius < radiusAt(kLowest) || radius > radiusAt(kHighest)) return {-1e6f, -1e6f};
  const float eta =
      (kXi + std::sqrt(1 + (1 - kXi * kXi) * radius * radius)) / (1 + radius * radius);
  const float level = eta * radius;  // sine of the angle from straight down
  const float down = eta - kXi;
  // Anticlockwise from ahead; the camera looks up, so what is on the left appears on the right.
  const float azimuth = std::atan2(offset.x, -offset.y);
  const float quarter = std::round(azimuth / (0.5f * kPi));
  const float within = azimuth - quarter * 0.5f * kPi;
  const cv::Size face = faceSize(focal);
  const int number = (static_cast<int>(quarter) + kFaces) % kFaces;
  return {
      static_cast<float>(number * face.width) + 0.5f * static_cast<float>(face.width) -
          focal * std::tan(within) - 0.5f,
      0.5f * static_cast<float>(face.height) + focal * down / (level * std::cos(within)) - 0.5f};
}

}  // namespace

MirrorRing mirrorRing(cv::Size size) {
  const float side = static_cast<float>(std::min(size.width, size.height));
  MirrorRing ring;
  ring.center = {0.5f * static_cast<float>(size.width) + 0.015f * side,
                 0.5f * static_cast<float>(size.height) - 0.01f * side};
  ring.outer = kRim * side;
  ring.inner = ring.outer * radiusAt(kLowest) / radiusAt(kHighest);
  return ring;
}

OmniRenderer::OmniRenderer(const Scene& scene, const RayTracer& tracer, const Lighting& lighting,
                           cv::Size size)
    : size_(size),
      focal_(1.1f * scaleOf(size)),  // matches the ring's resolution at the horizon
      faces_(scene, tracer, lighting, faceSize(focal_), focal_),
      map_(size, CV_32FC2) {
  const cv::Point2f center = mirrorRing(size).center;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Point2f pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      map_.at<cv::Vec2f>(y, x) = onFaces(pixel - center, scaleOf(size), focal_);
    }
  }
}

cv::Mat OmniRenderer::render(const View& view) const {
  const cv::Size face = faceSize(focal_);
  cv::Mat around(face.height, kFaces * face.width, CV_32FC3);
  for (int i = 0; i < kFaces; ++i) {
    const View side = turned(view, 0.5f * kPi * static_cast<float>(i));
    faces_.render(side).copyTo(around.colRange(i * face.width, (i + 1) * face.width));
  }
  cv::Mat radiance;
  cv::remap(around, radiance, map_, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar(kSurround[0], kSurround[1], kSurround[2]));
  return radiance;
}

}  // namespace place_recognition::simulation
