#include "features/response_filter.h"

#include <cassert>

#include "features/row_kernels.h"

namespace place_recognition {
namespace {

constexpr struct {
  Operator op;
  int x_order, y_order;
} kDerivatives[] = {{Operator::kValue, 0, 0}, {Operator::kX, 1, 0},  {Operator::kXX, 2, 0},
                    {Operator::kY, 0, 1},     {Operator::kXY, 1, 1}, {Operator::kYY, 0, 2}};

}  // namespace

ResponseFilter::ResponseFilter(double t, double half_width_sigmas, DerivativeMethod method) {
  const int half_width = gaussianHalfWidth(t, half_width_sigmas);
  margin_ = half_width + 1;  // What central differences need: both methods see the same pixels.
  for (int order = 0; order < 3; ++order) {
    kernels_[order] = gaussianKernel(t, half_width, order, method);
  }
  kernels_[0].taps.resize(kernels_[1].taps.size(), 0);  // a tap of zero changes no sum
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
  for (int op = 0; op < kOperators; ++op) {
    if (requested_[op]) rows_[op].resize(columns);
  }
  computeDerivatives(plane, y, left, columns);
  combineDerivatives(columns);
}

void ResponseFilter::computeDerivatives(const cv::Mat_<float>& plane, int y, int left,
                                        int columns) {
  const int n = columns + 2 * margin_;
  std::array<float*, 3> sums{};  // null: not wanted
  std::array<std::array<float*, 3>, 3> responses{};
  for (const auto& [op, x_order, y_order] : kDerivatives) {
    if (!requested(op)) continue;
    column_sums_[y_order].resize(n);
    sums[y_order] = column_sums_[y_order].data();
    responses[y_order][x_order] = buffer(op);
  }
  correlate(plane[y] + left - margin_, plane.step1(), kernels_, n, sums);
  for (int order = 0; order < 3; ++order) {
    if (sums[order]) correlate(sums[order] + margin_, 1, kernels_, columns, responses[order]);
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
