#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace place_recognition::simulation {

/// A point or direction in metres (x, y, z up), or a linear colour (B, G, R).
using Vec3 = cv::Vec3f;

/// The linear colour (B, G, R, each 0..1) of an sRGB triple 0..255.
Vec3 colour(float red, float green, float blue);

/// A repeating picture with a pyramid of reduced copies. Immutable, hence thread-safe.
class Texture {
 public:
  /// `picture` is CV_8UC3, sRGB, BGR; its sides are scaled to powers of two.
  explicit Texture(const cv::Mat& picture);

  /// The linear colour at (s, t), where the whole picture is the unit square and t points down,
  /// averaged over a footprint of about extent_s by extent_t.
  Vec3 sample(float s, float t, float extent_s, float extent_t) const;

  /// The linear colour of the whole picture.
  Vec3 average() const { return average_; }

 private:
  Vec3 bilinear(int level, float s, float t) const;

  /// CV_8UC4, the square root of the linear colour, for which eight bits are enough.
  std::vector<cv::Mat> levels_;
  Vec3 average_;
};

}  // namespace place_recognition::simulation
