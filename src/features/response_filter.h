#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/gaussian.h"

namespace place_recognition {

/// What can be taken of a channel at a scale (thesis section 4.1.2): the smoothed value, its
/// derivatives, with y pointing down, and |grad|, Laplacian and determinant of the Hessian.
enum class Operator { kValue, kX, kY, kXX, kXY, kYY, kGradient, kLaplacian, kDeterminant };
constexpr int kOperators = 9;

enum class DerivativeMethod {
  kCentralDifference,  ///< Smooth, then [-1/2 0 1/2] and [1 -2 1].
  kGaussian,           ///< Correlate with sampled derivatives of the Gaussian, eq. 4.10.
};

/// Responses of operators on one channel at one scale, not normalised by it. Goes through the image
/// row by row from the top, so that what it works on stays in the processor's cache.
class ResponseFilter {
 public:
  ResponseFilter(double t, double half_width_sigmas, DerivativeMethod method);

  /// Pixels at each side of the image where there are no responses.
  int margin() const { return kernels_[0].halfWidth() + 1; }
  /// Has computeRow() compute the responses of `op`.
  void request(Operator op);

  /// Begins with `plane`, which must outlive the last computeRow(). Columns left..left + columns - 1
  /// are asked for, all of them margin() or farther from the edges.
  void start(const cv::Mat_<float>& plane, int left, int columns);
  /// Computes row y, margin() or farther from the edges. Any row may be the first after start();
  /// then each follows the one before.
  void computeRow(int y);
  /// The responses of a requested operator in that row, column `left` first.
  const float* row(Operator op) const { return rows_[index(op)]; }

 private:
  static int index(Operator op) { return static_cast<int>(op); }
  bool requested(Operator op) const { return requested_[index(op)]; }
  float* buffer(Operator op);
  void differentiate(int y);
  void correlateDerivatives(int y);
  void smooth(int y);
  void combine();

  DerivativeMethod method_;
  std::array<HalfKernel, 3> kernels_;  ///< By order of derivative.
  std::array<bool, kOperators> requested_{};

  const cv::Mat_<float>* plane_ = nullptr;
  int left_ = 0;
  int columns_ = 0;
  int next_smooth_ = 0;             ///< The row to smooth next.
  std::vector<float> column_sums_;  ///< A row filtered down the columns, with a margin.
  std::array<std::vector<float>, 3> smooth_;  ///< Row y is y % 3; with one column more each side.
  std::array<std::vector<float>, kOperators> buffers_;
  std::array<const float*, kOperators> rows_{};
};

}  // namespace place_recognition
