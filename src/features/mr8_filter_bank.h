#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "features/image_fft.h"

namespace place_recognition {

/// The MR8 filter bank (Varma and Zisserman, IJCV 2005). Edge and bar filters are first and second
/// derivatives across an elongated Gaussian, at 3 scales and 6 orientations; only the strongest
/// response of each kind and scale is kept. The others are an isotropic Gaussian and its Laplacian.
class Mr8FilterBank {
 public:
  static constexpr int kResponses = 8;
  static constexpr int kSupport = 49;  ///< pixels, side of every filter
  static constexpr int kScales = 3;
  static constexpr int kOrientations = 6;

  /// Responses in order: edge at scales (1, 3), (2, 6), (4, 12); bar at the same; Gaussian;
  /// Laplacian. Edges and bars are magnitudes, because the sign of an edge depends on the
  /// direction of view.
  using Responses = std::array<cv::Mat1f, kResponses>;

  /// Filters `image`, which is mirrored beyond its borders. Resizes `responses` to its size.
  void apply(const cv::Mat1f& image, Responses& responses);

  /// The filters, of L1 norm one, with zero mean except the Gaussian. Scale: 0..2; orientation of
  /// the long axis: 0..5, in steps of 30 degrees from the x axis towards the y axis.
  static cv::Mat1f edge(int scale, int orientation);
  static cv::Mat1f bar(int scale, int orientation);
  static cv::Mat1f gaussian();
  static cv::Mat1f laplacian();

 private:
  using Numbers = ImageFft::Numbers;
  /// Real numbers in the order of an ImageFft::Spectrum.
  using Plane = std::vector<float>;

  void prepare(cv::Size tile);
  Plane spectrumOf(const cv::Mat1f& filter, float (Numbers::*part)[ImageFft::kLanes]);
  void pad(const cv::Mat1f& image, cv::Rect tile);
  void filterTile(cv::Rect tile, Responses& responses);
  Numbers* pairs(int x, cv::Rect tile);
  void takePairs(cv::Rect tile, cv::Mat1f& real, cv::Mat1f& imaginary);

  std::optional<ImageFft> fft_;
  // Bar filters are even and edge filters odd, so the spectrum of bar + i edge is real. Real
  // products suffice, and one inverse transform yields both responses.
  std::vector<Plane> bar_and_edge_;  ///< these spectra, scale by scale
  Plane gaussian_, laplacian_;       ///< real, because these filters are even
  cv::Mat1f padded_;                 ///< a tile with its margin
  ImageFft::Spectrum spectrum_;
  std::vector<Numbers> pairs_;  ///< two responses to a tile, kLanes columns interleaved
};

}  // namespace place_recognition
