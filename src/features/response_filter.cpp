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
  margin_ = half_width + 1;  // of central differences, so that both methods see the same pixels
  for (int order = 0; order < 3; ++order) {
    kernels_[order] = gaussianKernel(t, half_width, order, method);
  }
  kernels_[0].taps.resize(kernels_[1].taps.size(), 0);  // a zero tap does not change a sum
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

void ResponseFilter::computeRows(const RowRing& rows, int count, int margin,
                                 const StripedRows& lanes) {
  assert(margin >= margin_ && count <= kRows);
  column_sums_.create(3, lanes.size() + 2 * margin * StripedRows::kLanes);
  responses_.create(kRows * kOperators, lanes.size());
  for (int r = 0; r < count; ++r) {
    computeDerivatives(rows.row(margin + count - 1 - r), rows.step(), margin, lanes, r);
    combineDerivatives(r);
  }
}

void ResponseFilter::computeDerivatives(const float* in, std::ptrdiff_t step, int margin,
                                        const StripedRows& lanes, int r) {
  std::array<float*, 3> sums{};  // null: not requested
  std::array<std::array<float*, 3>, 3> responses{};
  for (const auto& [op, x_order, y_order] : kDerivatives) {
    if (!requested(op)) continue;
    sums[y_order] = column_sums_[y_order];
    responses[y_order][x_order] = buffer(op, r);
  }
  correlate(in, step, kernels_, lanes.size(), sums);
  for (int order = 0; order < 3; ++order) {
    if (!sums[order]) continue;
    lanes.lengthen(2 * margin, sums[order]);
    correlate(sums[order] + margin * StripedRows::kLanes, StripedRows::kLanes, kernels_,
              lanes.size(), responses[order]);
  }
}

void ResponseFilter::combineDerivatives(int r) {
  const int n = responses_.cols;
  const float *x = row(Operator::kX, r), *y = row(Operator::kY, r);
  const float *xx = row(Operator::kXX, r), *xy = row(Operator::kXY, r), *yy = row(Operator::kYY, r);
  if (requested(Operator::kGradient)) {
    gradientMagnitude(x, y, n, buffer(Operator::kGradient, r));
  }
  if (requested(Operator::kLaplacian)) laplacian(xx, yy, n, buffer(Operator::kLaplacian, r));
  if (requested(Operator::kDeterminant)) {
    hessianDeterminant(xx, xy, yy, n, buffer(Operator::kDeterminant, r));
  }
}

}  // namespace place_recognition
