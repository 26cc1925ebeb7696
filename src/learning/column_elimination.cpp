#include "learning/column_elimination.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// Partial sums: as many as two registers of the widest instruction set hold.
constexpr Eigen::Index kLanes = 16;

/// Sum of the lanes in a fixed order.
PLACE_RECOGNITION_INLINE double sumOf(double* lanes) {
  for (Eigen::Index half = kLanes / 2; half > 0; half /= 2) {
    for (Eigen::Index i = 0; i < half; ++i) lanes[i] += lanes[i + half];
  }
  return lanes[0];
}

/// Takes out of column `a` its part along the unit vector q. Returns q'a.
PLACE_RECOGNITION_TARGET_CLONES
double project(const double* q, double* a, Eigen::Index n, double* squared_norm) {
  double lanes[kLanes] = {};
  Eigen::Index i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    for (Eigen::Index k = 0; k < kLanes; ++k) lanes[k] += q[i + k] * a[i + k];
  }
  for (Eigen::Index k = 0; i + k < n; ++k) lanes[k] += q[i + k] * a[i + k];
  const double product = sumOf(lanes);

  std::fill(lanes, lanes + kLanes, 0.0);
  for (i = 0; i + kLanes <= n; i += kLanes) {
    for (Eigen::Index k = 0; k < kLanes; ++k) {
      a[i + k] -= product * q[i + k];
      lanes[k] += a[i + k] * a[i + k];
    }
  }
  for (Eigen::Index k = 0; i + k < n; ++k) {
    a[i + k] -= product * q[i + k];
    lanes[k] += a[i + k] * a[i + k];
  }
  *squared_norm = sumOf(lanes);
  return product;
}

}  // namespace

ColumnElimination::ColumnElimination(Eigen::MatrixXd columns, Eigen::Index candidates)
    : columns_(std::move(columns)),
      candidates_(candidates),
      squared_norms_(columns_.colwise().squaredNorm()),
      left_(static_cast<std::size_t>(columns_.cols())),
      r_(std::min(columns_.rows(), candidates), columns_.cols()) {
  std::iota(left_.begin(), left_.end(), 0);
}

void ColumnElimination::choose(Eigen::Index column) {
  assert(column < candidates_ && squared_norms_[column] > 0);
  const double norm = std::sqrt(squared_norms_[column]);
  columns_.col(column) /= norm;
  left_.erase(std::find(left_.begin(), left_.end(), column));
  auto row = r_.row(static_cast<Eigen::Index>(chosen_.size()));
  row.setZero();
  row[column] = norm;
  squared_norms_[column] = 0;
  for (const Eigen::Index j : left_) {
    row[j] = project(columns_.col(column).data(), columns_.col(j).data(), columns_.rows(),
                     &squared_norms_[j]);
  }
  chosen_.push_back(column);
}

Eigen::MatrixXd ColumnElimination::targetProducts() const {
  return columns_.leftCols(candidates_).transpose() *
         columns_.rightCols(columns_.cols() - candidates_);
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
