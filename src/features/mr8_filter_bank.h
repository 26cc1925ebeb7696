#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

namespace place_recognition {

/// The MR8 filter bank (Varma and Zisserman, IJCV 2005): edge and bar filters, first and second
/// derivatives across an elongated Gaussian, at 3 scales and 6 orientations, of which only the
/// strongest response of each kind and scale is kept; an isotropic Gaussian; its Laplacian.
class Mr8FilterBank {
 public:
  static constexpr int kResponses = 8;
  static constexpr int kSupport = 49;  ///< pixels, side of every filter
  static constexpr int kScales = 3;
  static constexpr int kOrientations = 6;

  /// Responses in order: edge at scales (1, 3), (2, 6), (4, 12); bar at the same; Gaussian;
  /// Laplacian. Edges and bars are magnitudes: an edge's sign would tell the direction of view.
  using Responses = std::array<cv::Mat1f, kResponses>;

  /// Filters `image`, mirrored beyond its edges; `responses` get its size.
  void apply(const cv::Mat1f& image, Responses& responses);

  /// The filters: zero mean but for the Gaussian, and of L1 norm one. Scale 0..2, orientation 0..5
  /// in steps of 30 degrees, from the x axis towards the y axis, of the long axis.
  static cv::Mat1f edge(int scale, int orientation);
  static cv::Mat1f bar(int scale, int orientation);
  static cv::Mat1f gaussian();
  static cv::Mat1f laplacian();

 private:
  void prepare(cv::Size size);

  // An edge filter is odd and a bar filter even, so the spectrum of edge + i bar is i times a real
  // one: real products do, and one inverse transform gives both responses.
  std::vector<cv::Mat1f> edge_and_bar_;  ///< scale by scale, those real spectra
  cv::Mat1f gaussian_spectrum_;          ///< even filters: real
  cv::Mat1f laplacian_spectrum_;
  cv::Mat1f padded_;
  cv::Mat2f spectrum_;
  cv::Mat2f filtered_;
};

}  // namespace place_recognition
