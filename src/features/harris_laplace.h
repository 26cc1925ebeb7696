#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "features/gaussian_filter.h"
#include "features/gaussian_pyramid.h"

namespace place_recognition {

/// A corner at its characteristic scale.
struct InterestPoint {
  float x;           ///< pixels of the image; the upper left pixel's centre is (0, 0)
  float y;           ///< pixels
  float sigma;       ///< characteristic scale, pixels
  float cornerness;  ///< eq. 4.26, grey levels^4, comparable over scales
};

/// The Harris-Laplace detector, thesis section 4.3.1: local maxima of the cornerness, at scales
/// where the Laplacian of Gaussian has an extremum at that point. Keeps its buffers: use one per
/// thread.
class HarrisLaplace {
 public:
  struct Options {
    double sigma;                 ///< finest integration scale sigma_I, pixels
    int steps;                    ///< integration scales per octave, even
    int octaves;                  ///< maximum
    double alpha;                 ///< of eq. 4.26
    double cornerness_threshold;  ///< grey levels^4
    double laplacian_threshold;   ///< of |t (L_xx + L_yy)|, grey levels
  };

  explicit HarrisLaplace(const Options& options);

  /// Returns the `limit` strongest points of `image` (grey levels, 0..255), strongest first. Valid
  /// until the next call.
  const std::vector<InterestPoint>& detect(const cv::Mat1f& image, std::size_t limit);
  /// The scale space of the last image.
  const GaussianPyramid& pyramid() const { return pyramid_; }

 private:
  void computeCornerness(const cv::Mat1f& smoothed, int step);
  void findCorners(int octave, int step);
  void selectScales(const cv::Point2d& corner, int octave, int step, float cornerness);
  double laplacian(const cv::Point2d& place, int scale) const;
  void keepStrongest(std::size_t limit);

  Options options_;
  /// Number of an integration scale sigma_I minus that of its differentiation scale: half an
  /// octave, sigma_D = sigma_I / sqrt(2), so that both are scales of one pyramid.
  int integration_offset_;
  GaussianPyramid pyramid_;
  std::vector<std::vector<GaussianFilter>> windows_;  ///< of each step: g(t_I) for xx, xy and yy
  std::vector<float> moments_;                        ///< one row each of mu_xx, mu_xy, mu_yy
  cv::Mat1f cornerness_;                              ///< of one level
  std::vector<unsigned char> is_peak_;                ///< of one row
  std::vector<InterestPoint> candidates_;
  std::vector<InterestPoint> points_;
};

}  // namespace place_recognition
