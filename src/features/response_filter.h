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

/// Responses of operators on one channel at one scale, not normalised by it. Works row by row, so
/// that all it touches stays in the processor's cache. Each derivative is correlated with its own
/// kernel down the columns and along the row, rather than taken as the difference of smoothed
/// values: there rounding would drown the small ones, and zero would not stay zero.
class ResponseFilter {
 public:
  ResponseFilter(double t, double half_width_sigmas, DerivativeMethod method);

  /// Pixels at each side of the image where there are no responses.
  int margin() const { return margin_; }
  /// Has computeRow() compute the responses of `op`.
  void request(Operator op);

  /// Computes row y of `plane` in columns left..left + columns - 1, all of them margin() or farther
  /// from the edges.
  void computeRow(const cv::Mat_<float>& plane, int y, int left, int columns);
  /// The responses of a requested operator in that row, column `left` first.
  const float* row(Operator op) const { return rows_[index(op)].data(); }

 private:
  static int index(Operator op) { return static_cast<int>(op); }
  bool requested(Operator op) const { return requested_[index(op)]; }
  float* buffer(Operator op) { return rows_[index(op)].data(); }
  void computeDerivatives(const cv::Mat_<float>& plane, int y, int left, int columns);
  void combineDerivatives(int columns);

  int margin_;
  std::array<HalfKernel, 3> kernels_;  ///< By order of derivative, all of one width.
  std::array<bool, kOperators> requested_{};
  /// A row correlated down the columns, with its margins, by order.
  std::array<std::vector<float>, 3> column_sums_;
  std::array<std::vector<float>, kOperators> rows_;
};

}  // namespace place_recognition
