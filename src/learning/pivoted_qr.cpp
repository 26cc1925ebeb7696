#include "learning/pivoted_qr.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// Columns are padded to a multiple of this: two registers of the widest instruction set. Sums are
/// kept in as many parts, so that the order of additions does not depend on the registers.
constexpr Eigen::Index kPadding = 16;

PLACE_RECOGNITION_TARGET_CLONES
void multiply(const double* x, double factor, Eigen::Index n, double* out) {
  for (Eigen::Index i = 0; i < n; ++i) out[i] = factor * x[i];
}

/// Adds the parts of a sum.
PLACE_RECOGNITION_INLINE double total(double* sums) {
  for (Eigen::Index count = kPadding / 2; count > 0; count /= 2) {
    for (Eigen::Index k = 0; k < count; ++k) sums[k] += sums[k + count];
  }
  return sums[0];
}

/// x'y of `n` numbers, a multiple of kPadding.
PLACE_RECOGNITION_TARGET_CLONES
double innerProduct(const double* x, const double* y, Eigen::Index n) {
  double sums[kPadding] = {};
  for (Eigen::Index i = 0; i < n; i += kPadding) {
    for (Eigen::Index k = 0; k < kPadding; ++k) sums[k] += x[i + k] * y[i + k];
  }
  return total(sums);
}

/// y -= factor x.
PLACE_RECOGNITION_TARGET_CLONES
void subtract(double factor, const double* __restrict x, Eigen::Index n, double* __restrict y) {
  for (Eigen::Index i = 0; i < n; ++i) y[i] -= factor * x[i];
}

/// y -= factor x, in the same pass as the z'y that it returns.
PLACE_RECOGNITION_TARGET_CLONES
double subtractAndMultiply(double factor, const double* __restrict x, const double* __restrict z,
                           Eigen::Index n, double* __restrict y) {
  double sums[kPadding] = {};
  for (Eigen::Index i = 0; i < n; i += kPadding) {
    for (Eigen::Index k = 0; k < kPadding; ++k) {
      y[i + k] -= factor * x[i + k];
      sums[k] += z[i + k] * y[i + k];
    }
  }
  return total(sums);
}

}  // namespace

PivotedQr::PivotedQr(Eigen::Index rows, Eigen::Index candidates, Eigen::Index targets)
    : rows_(rows),
      padded_rows_((rows + kPadding - 1) / kPadding * kPadding),
      candidates_(candidates),
      storage_(static_cast<std::size_t>(padded_rows_ * (candidates + targets)), 0),
      squared_norms_(Eigen::VectorXd::Zero(candidates + targets)),
      steps_(static_cast<std::size_t>(candidates + targets), 0),
      r_(Eigen::MatrixXd::Zero(std::min(rows, candidates), candidates + targets)) {}

void PivotedQr::set(Eigen::Index column, const Eigen::Ref<const Eigen::VectorXd>& values,
                    double scale) {
  double* stored = columns().col(column).data();
  multiply(values.data(), 1 / scale, rows_, stored);
  squared_norms_[column] = innerProduct(stored, stored, padded_rows_);
}

void PivotedQr::choose(Eigen::Index column) {
  assert(column < candidates_ && isUpToDate(column) && squared_norms_[column] > 0);
  const double norm = std::sqrt(squared_norms_[column]);
  double* q = columns().col(column).data();
  multiply(q, 1 / norm, padded_rows_, q);
  squared_norms_[column] = 0;
  r_(rank(), column) = norm;
  chosen_.push_back(column);
}

void PivotedQr::update(Eigen::Index column) {
  if (isUpToDate(column)) return;
  double* values = columns().col(column).data();
  Eigen::Index& step = steps_[static_cast<std::size_t>(column)];
  const auto direction = [this](Eigen::Index i) -> const double* {
    return columns().col(chosen_[static_cast<std::size_t>(i)]).data();
  };
  r_(step, column) = innerProduct(direction(step), values, padded_rows_);
  for (; step + 1 < rank(); ++step) {
    r_(step + 1, column) = subtractAndMultiply(r_(step, column), direction(step),
                                               direction(step + 1), padded_rows_, values);
  }
  subtract(r_(step, column), direction(step), padded_rows_, values);
  ++step;
  squared_norms_[column] = innerProduct(values, values, padded_rows_);
}

void PivotedQr::updateAll() {
  for (Eigen::Index column = 0; column < squared_norms_.size(); ++column) update(column);
}

Eigen::MatrixXd PivotedQr::targetProducts() {
  const Columns all = columns();
  return all.leftCols(candidates_).transpose() * all.rightCols(all.cols() - candidates_);
}

Eigen::MatrixXd solveTriangular(const Eigen::MatrixXd& r, const std::vector<Eigen::Index>& chosen,
                                const Eigen::MatrixXd& b) {
  Eigen::MatrixXd r11(b.rows(), b.rows());
  for (Eigen::Index i = 0; i < b.rows(); ++i) {
    r11.col(i) = r.col(chosen[static_cast<std::size_t>(i)]).head(b.rows());
  }
  return r11.triangularView<Eigen::Upper>().solve(b);
}

}  // namespace place_recognition
