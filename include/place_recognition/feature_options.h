#pragma once

#include <string>
#include <variant>
#include <vector>

#include "place_recognition/embedding_options.h"
#include "place_recognition/hog_options.h"
#include "place_recognition/local_feature_options.h"
#include "place_recognition/texture_options.h"

namespace place_recognition {

// Each option struct lists its fields once, in visit(): the YAML reader, the YAML writer and the
// generated documentation all use that list (src/base/options.h). `Self` is the struct, const or
// not. check() throws Error naming the offending field; `key` is the key of the struct as a user
// writes it.

/// Composed receptive field histograms, thesis section 4.2.
struct CrfhOptions {
  static constexpr const char* kType = "crfh";

  std::vector<std::string> descriptors = {"Lxx", "Lxy", "Lyy"};
  std::vector<double> scales = {1, 4};
  std::vector<double> sigmas = {};
  std::vector<int> bins = {28};
  std::string levels = "linear";
  std::string derivatives = "central-difference";
  double derivative_range = 128;
  double half_width = 3;
  int border = 15;

  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("descriptors", self.descriptors,
            "one dimension each, all at the first scale, then all at the second and so on: a "
            "channel L, R, G, B, C1 or C2, alone or followed by x, y, xx, xy or yy; or grad(.), "
            "lap(.), det(.) of a channel");
    visitor("scales", self.scales, "t = sigma^2, pixels^2, each 0.01 to 400");
    visitor("sigmas", self.sigmas, "the scales as sigma, pixels; replaces scales if not empty");
    visitor("bins", self.bins, "quantization levels: one number, or one for each descriptor");
    visitor("levels", self.levels,
            "linear: grey levels v unchanged; logarithmic: log(1 + v / 16), scaled to 0..255, so "
            "that an edge is a ratio of brightness, which a change of light does not alter");
    visitor("derivatives", self.derivatives,
            "central-difference (of the smoothed image) or gaussian (sampled, eq. 4.10)");
    visitor("derivative_range", self.derivative_range,
            "normalized derivatives are quantized in -range..range, grad in 0..range, grey levels; "
            "det(.) in a quarter of it, grey levels^2");
    visitor("half_width", self.half_width, "half-width of the Gaussian, in sigma");
    visitor("border", self.border,
            "pixels at each side that are not counted; larger for large scales");
  }
  /// The scales as t = sigma^2, from either of the two keys.
  std::vector<double> variances() const;
  void check(const std::string& key = "feature") const;
};

/// The feature of one cue; the key `type` names the alternative.
using FeatureOptions = std::variant<CrfhOptions, LocalFeatureOptions, LbpOptions, Mr8Options,
                                    HogOptions, EmbeddingOptions>;

}  // namespace place_recognition
