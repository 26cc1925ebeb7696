#pragma once

#include <array>
#include <cstddef>
#include <opencv2/core/mat.hpp>

#include "features/gaussian.h"
#include "features/row_ring.h"
#include "features/striped_rows.h"

namespace place_recognition {

/// What a descriptor computes from a channel at a scale (thesis section 4.1.2): the smoothed value,
/// its derivatives (y points down), the gradient's magnitude, the Laplacian, or the determinant of
/// the Hessian.
enum class Operator { kValue, kX, kY, kXX, kXY, kYY, kGradient, kLaplacian, kDeterminant };
constexpr int kOperators = 9;

/// Responses of operators on one channel at one scale, not normalized by the scale. Works on a few
/// rows at a time, so that the memory in use stays in the processor's cache. Each derivative is
/// correlated with its own kernel along columns and rows. Differences of smoothed values would be
/// less accurate: rounding would dominate small derivatives, and zero would not stay zero.
class ResponseFilter {
 public:
  ResponseFilter(double t, double half_width_sigmas, DerivativeMethod method);

  /// Pixels at each side of the image where there are no responses.
  int margin() const { return margin_; }
  /// Makes computeRows() compute the responses of `op`.
  void request(Operator op);

  /// Maximum number of rows computed at a time. The second row finds in the processor's first-level
  /// cache what the first brought there.
  static constexpr int kRows = 2;
  /// Computes the responses in `count` rows that are stored in lanes; the last of them was pushed
  /// `margin` >= margin() rows ago.
  void computeRows(const RowRing& rows, int count, int margin, const StripedRows& lanes);
  /// The responses of a requested operator in row r of those, in lanes: for pixels margin, margin +
  /// 1 and so on; the last 2 margin pixels have none.
  const float* row(Operator op, int r) const { return responses_[r * kOperators + index(op)]; }

 private:
  static int index(Operator op) { return static_cast<int>(op); }
  bool requested(Operator op) const { return requested_[index(op)]; }
  float* buffer(Operator op, int r) { return responses_[r * kOperators + index(op)]; }
  void computeDerivatives(const float* in, std::ptrdiff_t step, int margin,
                          const StripedRows& lanes, int r);
  void combineDerivatives(int r);

  int margin_;
  std::array<HalfKernel, 3> kernels_;  ///< By order of derivative; all have the same width.
  std::array<bool, kOperators> requested_{};
  cv::Mat_<float> column_sums_;  ///< a row correlated along the columns, by order
  cv::Mat_<float> responses_;    ///< of one row by operator, then of the next row
};

}  // namespace place_recognition
