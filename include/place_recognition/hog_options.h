#pragma once

#include <cstddef>
#include <string>

namespace place_recognition {

/// Histograms of oriented gradients (Dalal and Triggs 2005) of a few large cells, which together
/// cover the image. For visit() and check(), see feature_options.h.
struct HogOptions {
  static constexpr const char* kType = "hog";

  int rows = 4;
  int columns = 1;
  int orientations = 9;
  int width = 320;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("rows", self.rows,
            "the image is divided into rows x columns cells with one histogram each, 1..16");
    visitor("columns", self.columns,
            "1..16; 1: whole rows of the image, which do not tell left from right");
    visitor("orientations", self.orientations,
            "bins for the directions 0..180 degrees of the gradient, 2..36");
    visitor("width", self.width, "pixels, 32..1024; wider images are scaled down to it");
  }
  void check(const std::string& key = "feature") const;

  /// Number of values in the feature.
  std::size_t dimension() const { return static_cast<std::size_t>(rows * columns * orientations); }
};

}  // namespace place_recognition
