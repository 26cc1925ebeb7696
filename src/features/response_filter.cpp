#include "features/response_filter.h"

#include <cassert>

#include "features/row_kernels.h"

namespace place_recognition {

ResponseFilter::ResponseFilter(double t, double half_width_sigmas, DerivativeMethod method) {
  const int half_width = gaussianHalfWidth(t, half_width_sigmas);
  margin_ = half_width + 1;  // What central differences need: both methods see the same pixels.
  for (int order = 0; order < 3; ++order) {
    kernels_[order] = gaussianKernel(t, half_width, order, method);
  }
}

void ResponseFilter::request(Operator op) {
  requested_[index(op)] = true;
  if (op == Operator::kGradient) {
    for (Operator part : {Operator::kX, Operator::kY}) request(part);
  } else if (op == Operator::kLaplacian || op == Operator::kDeterminant) {
    for (Operator part : {Operator::kXX, Operator::kYY}) request(part);
    if (op == Operator::kDeterminant) request(Operator::kXY);
  }
}

void ResponseFilter::computeRow(const cv::Mat_<float>& plane, int y, int left, int columns) {
  assert(y >= margin_ && y < plane.rows - margin_);
  assert(left >= margin_ && left + columns <= plane.cols - margin_);
  column_sums_.resize(columns + 2 * margin_);
  for (int op = 0; op < kOperators; ++op) {
    if (requested_[op]) rows_[op].resize(columns);
  }
  computeDerivatives(plane, y, left, columns);
  combineDerivatives(columns);
}

void ResponseFilter::computeDerivatives(const cv::Mat_<float>& plane, int y, int left,
                                        int columns) {
  static constexpr struct {
    Operator op;
    int x_order, y_order;
  } kDerivatives[] = {{Operator::kValue, 0, 0}, {Operator::kX, 1, 0},  {Operator::kXX, 2, 0},
                      {Operator::kY, 0, 1},     {Operator::kXY, 1, 1}, {Operator::kYY, 0, 2}};
  int order = -1;  // The y order that column_sums_ holds.
  for (const auto& [op, x_order, y_order] : kDerivatives) {
    if (!requested(op)) continue;
    if (y_order != order) {
      correlate(plane[y] + left - margin_, plane.step1(), kernels_[y_order], columns + 2 * margin_,
                column_sums_.data());
      order = y_order;
    }
    correlate(column_sums_.data() + margin_, 1, kernels_[x_order], columns, buffer(op));
  }
}

void ResponseFilter::combineDerivatives(int columns) {
  const float *x = row(Operator::kX), *y = row(Operator::kY);
  const float *xx = row(Operator::kXX), *xy = row(Operator::kXY), *yy = row(Operator::kYY);
  if (requested(Operator::kGradient)) {
    gradientMagnitude(x, y, columns, buffer(Operator::kGradient));
  }
  if (requested(Operator::kLaplacian)) laplacian(xx, yy, columns, buffer(Operator::kLaplacian));
  if (requested(Operator::kDeterminant)) {
    hessianDeterminant(xx, xy, yy, columns, buffer(Operator::kDeterminant));
  }
}

}  // namespace place_recognition
