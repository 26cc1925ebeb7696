#pragma once

#include <string>

namespace place_recognition {

/// SIFT descriptors at Harris-Laplace interest points, thesis section 4.3. For visit() and check(),
/// see feature_options.h.
struct LocalFeatureOptions {
  static constexpr const char* kType = "harris-laplace-sift";

  double sigma = 2;
  int steps = 4;
  int octaves = 5;
  double alpha = 0.05;
  double cornerness_threshold = 100;
  double laplacian_threshold = 5;
  bool upright = false;
  int max_points = 400;
  int min_points = 5;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("sigma", self.sigma, "finest integration scale sigma_I, pixels, 1..10");
    visitor("steps", self.steps, "integration scales per octave: 2, 4, 6 or 8");
    visitor("octaves", self.octaves, "most octaves of scale, 1..10; fewer in small images");
    visitor("alpha", self.alpha,
            "weight of the squared trace in the cornerness (eq. 4.26), 0..0.2");
    visitor("cornerness_threshold", self.cornerness_threshold,
            "weakest corner accepted, grey levels^4, > 0");
    visitor("laplacian_threshold", self.laplacian_threshold,
            "smallest Laplacian t |Lxx + Lyy| at the characteristic scale, grey levels, >= 0");
    visitor("upright", self.upright,
            "true: descriptors are not rotated with the image, for cameras that never roll");
    visitor("max_points", self.max_points, "most points, the strongest first, 1..20000");
    visitor("min_points", self.min_points, "images with fewer points have no feature, >= 1");
  }
  void check(const std::string& key = "feature") const;
};

}  // namespace place_recognition
