#pragma once

#include <string>
#include <vector>

namespace place_recognition {

// The texture descriptors of thesis chapter 7. For visit() and check(), see feature_options.h.

/// One operator LBP(riu2, P, R).
struct LbpCircle {
  int points = 8;
  double radius = 1;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("points", self.points, "neighbours P compared with each pixel, 4..32");
    visitor("radius", self.radius, "radius R of their circle, pixels, 0.5..16");
  }
};

/// Local binary patterns, uniform, rotation invariant and multi-resolution (Ojala, Pietikainen and
/// Maenpaa 2002).
struct LbpOptions {
  static constexpr const char* kType = "lbp";

  std::vector<LbpCircle> circles = {{8, 1}, {16, 2}, {24, 3}};

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("circles", self.circles, "one histogram of points + 2 bins each, concatenated");
  }
  void check(const std::string& key = "feature") const;
};

/// Maximum responses of the MR8 filter bank (Varma and Zisserman 2005), as a joint histogram.
struct Mr8Options {
  static constexpr const char* kType = "mr8";

  int bins = 4;
  double range = 1;
  bool weber = true;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("bins", self.bins, "quantization levels of each of the 8 responses, 2..200");
    visitor("range", self.range,
            "edges and bars are quantized in 0..range, the Gaussian and its Laplacian in "
            "-range..range; values beyond it count as the last level");
    visitor("weber", self.weber,
            "scale each pixel's responses r by log(1 + |r| / 0.03) / |r|, to reduce the effect of "
            "contrast");
  }
  void check(const std::string& key = "feature") const;
};

}  // namespace place_recognition
