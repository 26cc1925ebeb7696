#include "features/response_filter.h"

#include <algorithm>
#include <cassert>

#include "features/row_kernels.h"

namespace place_recognition {

ResponseFilter::ResponseFilter(double t, double half_width_sigmas, DerivativeMethod method)
    : method_(method) {
  const int half_width = gaussianHalfWidth(t, half_width_sigmas);
  for (int order = 0; order < 3; ++order) kernels_[order] = gaussianKernel(t, half_width, order);
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

void ResponseFilter::start(const cv::Mat_<float>& plane, int left, int columns) {
  assert(left >= margin() && left + columns <= plane.cols - margin());
  plane_ = &plane;
  left_ = left;
  columns_ = columns;
  next_smooth_ = 0;
  column_sums_.resize(columns + 2 * margin());
  for (auto& row : smooth_) row.resize(columns + 2);
  for (auto& buffer : buffers_) buffer.resize(columns);
}

void ResponseFilter::computeRow(int y) {
  assert(y >= margin() && y < plane_->rows - margin());
  if (method_ == DerivativeMethod::kCentralDifference) {
    differentiate(y);
  } else {
    correlateDerivatives(y);
  }
  combine();
}

float* ResponseFilter::buffer(Operator op) {
  float* buffer = buffers_[index(op)].data();
  rows_[index(op)] = buffer;
  return buffer;
}

void ResponseFilter::smooth(int y) {
  // Columns left - 1 to left + columns are wanted, and half the kernel more to get them.
  const int half = kernels_[0].halfWidth();
  correlate((*plane_)[y] + left_ - 1 - half, plane_->step1(), kernels_[0],
            columns_ + 2 + 2 * half, column_sums_.data());
  correlate(column_sums_.data() + half, 1, kernels_[0], columns_ + 2, smooth_[y % 3].data());
}

void ResponseFilter::differentiate(int y) {
  for (int row = std::max(y - 1, next_smooth_); row <= y + 1; ++row) smooth(row);
  next_smooth_ = y + 2;

  const float* above = smooth_[(y - 1) % 3].data() + 1;
  const float* here = smooth_[y % 3].data() + 1;
  const float* below = smooth_[(y + 1) % 3].data() + 1;
  const int n = columns_;
  rows_[index(Operator::kValue)] = here;
  if (requested(Operator::kX)) differenceX(here, n, buffer(Operator::kX));
  if (requested(Operator::kY)) differenceY(above, below, n, buffer(Operator::kY));
  if (requested(Operator::kXX)) differenceXX(here, n, buffer(Operator::kXX));
  if (requested(Operator::kXY)) differenceXY(above, below, n, buffer(Operator::kXY));
  if (requested(Operator::kYY)) differenceYY(above, here, below, n, buffer(Operator::kYY));
}

void ResponseFilter::correlateDerivatives(int y) {
  static constexpr struct {
    Operator op;
    int x_order, y_order;
  } kDerivatives[] = {{Operator::kValue, 0, 0}, {Operator::kX, 1, 0},  {Operator::kXX, 2, 0},
                      {Operator::kY, 0, 1},     {Operator::kXY, 1, 1}, {Operator::kYY, 0, 2}};
  const int half = kernels_[0].halfWidth();
  int filtered_order = -1;  // The y order that column_sums_ holds.
  for (const auto& [op, x_order, y_order] : kDerivatives) {
    if (!requested(op)) continue;
    if (y_order != filtered_order) {
      correlate((*plane_)[y] + left_ - half, plane_->step1(), kernels_[y_order],
                columns_ + 2 * half, column_sums_.data());
      filtered_order = y_order;
    }
    correlate(column_sums_.data() + half, 1, kernels_[x_order], columns_, buffer(op));
  }
}

void ResponseFilter::combine() {
  const int n = columns_;
  if (requested(Operator::kGradient)) {
    gradientMagnitude(row(Operator::kX), row(Operator::kY), n, buffer(Operator::kGradient));
  }
  if (requested(Operator::kLaplacian)) {
    laplacian(row(Operator::kXX), row(Operator::kYY), n, buffer(Operator::kLaplacian));
  }
  if (requested(Operator::kDeterminant)) {
    hessianDeterminant(row(Operator::kXX), row(Operator::kXY), row(Operator::kYY), n,
                       buffer(Operator::kDeterminant));
  }
}

}  // namespace place_recognition
