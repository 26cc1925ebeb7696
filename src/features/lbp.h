#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "features/feature_extractor.h"
#include "place_recognition/texture_options.h"

namespace place_recognition {

/// Uniform rotation-invariant local binary patterns LBP(riu2, P, R) of one circle (Ojala,
/// Pietikainen and Maenpaa 2002, eq. 10). A pixel's code is the number of its P neighbours on a
/// circle of radius R that are at least as bright as the pixel, if this relation changes at most
/// twice around the circle, and P + 1 otherwise. The codes are exact: neighbours between pixels are
/// interpolated in integers, so uniform areas get the right code, and an image turned by 90 degrees
/// gives the same codes.
class LbpOperator {
 public:
  explicit LbpOperator(const LbpCircle& circle);

  /// Pixels at each side of the image without a code.
  int border() const { return border_; }
  int codes() const { return static_cast<int>(neighbours_.size()) + 2; }
  /// Codes of row `y` of `image` (CV_8UC1), columns border() .. cols - border() - 1. Valid until
  /// the next call.
  const std::vector<std::int32_t>& encodeRow(const cv::Mat1b& image, int y);

 private:
  /// A bilinear interpolation between four pixels; the weights sum to 2^kWeightBits.
  struct Neighbour {
    std::array<cv::Point, 4> pixels;  ///< relative to the centre
    std::array<std::int32_t, 4> weights;
  };

  static Neighbour neighbourAt(double dx, double dy);

  int border_;
  std::vector<Neighbour> neighbours_;  ///< around the circle
  std::vector<std::int32_t> ones_, changes_, first_, last_, codes_;
};

/// Histograms of the codes of several circles, each with sum 1, concatenated: a DenseVector.
class LbpExtractor : public FeatureExtractor {
 public:
  /// Throws Error if an option is out of range.
  explicit LbpExtractor(const LbpOptions& options);

  void extract(const cv::Mat& image, Feature& feature) override;

 private:
  std::vector<LbpOperator> operators_;
  cv::Mat converted_;
};

}  // namespace place_recognition
