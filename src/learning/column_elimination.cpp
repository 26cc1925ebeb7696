#include "learning/column_elimination.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// Columns are padded to a multiple of this: two registers of the widest instruction set.
constexpr Eigen::Index kLanes = 16;

/// Sum of term(i) over i in 0..n-1, a multiple of kLanes, in an order that is the same for every
/// instruction set.
template <typename Term>
PLACE_RECOGNITION_INLINE double sumOver(Eigen::Index n, Term term) {
  double lanes[kLanes] = {};
  for (Eigen::Index i = 0; i < n; i += kLanes) {
    for (Eigen::Index k = 0; k < kLanes; ++k) lanes[k] += term(i + k);
  }
  for (Eigen::Index half = kLanes / 2; half > 0; half /= 2) {
    for (Eigen::Index k = 0; k < half; ++k) lanes[k] += lanes[k + half];
  }
  return lanes[0];
}

/// q'a.
PLACE_RECOGNITION_TARGET_CLONES
double multiply(const double* q, const double* a, Eigen::Index n) {
  return sumOver(n, [=](Eigen::Index i) { return q[i] * a[i]; });
}

/// a -= product * q; returns next'a. One pass serves two steps.
PLACE_RECOGNITION_TARGET_CLONES
double subtractAndMultiply(double product, const double* q, const double* next,
                           double* __restrict a, Eigen::Index n) {
  return sumOver(n, [=](Eigen::Index i) {
    a[i] -= product * q[i];
    return next[i] * a[i];
  });
}

/// a -= product * q; returns a'a.
PLACE_RECOGNITION_TARGET_CLONES
double subtractAndSquare(double product, const double* q, double* __restrict a, Eigen::Index n) {
  return sumOver(n, [=](Eigen::Index i) {
    a[i] -= product * q[i];
    return a[i] * a[i];
  });
}

}  // namespace

ColumnElimination::ColumnElimination(Eigen::Index rows, Eigen::Index candidates,
                                     Eigen::Index targets)
    : rows_(rows),
      padded_rows_((rows + kLanes - 1) / kLanes * kLanes),
      candidates_(candidates),
      storage_(static_cast<std::size_t>(padded_rows_ * (candidates + targets)), 0),
      squared_norms_(Eigen::VectorXd::Zero(candidates + targets)),
      steps_(static_cast<std::size_t>(candidates + targets), 0),
      r_(Eigen::MatrixXd::Zero(std::min(rows, candidates), candidates + targets)) {}

void ColumnElimination::set(Eigen::Index column, const Eigen::Ref<const Eigen::VectorXd>& values,
                            double scale) {
  auto stored = columns().col(column);
  stored.head(rows_) = values / scale;
  squared_norms_[column] = multiply(stored.data(), stored.data(), padded_rows_);
}

void ColumnElimination::choose(Eigen::Index column) {
  assert(column < candidates_ && isSettled(column) && squared_norms_[column] > 0);
  const double norm = std::sqrt(squared_norms_[column]);
  columns().col(column) /= norm;
  squared_norms_[column] = 0;
  r_(rank(), column) = norm;
  chosen_.push_back(column);
}

bool ColumnElimination::isSettled(Eigen::Index column) const {
  return squared_norms_[column] == 0 || steps_[static_cast<std::size_t>(column)] == rank();
}

void ColumnElimination::settle(Eigen::Index column) {
  Eigen::Index& step = steps_[static_cast<std::size_t>(column)];
  if (isSettled(column)) return;
  const auto q = [this](Eigen::Index k) {
    return columns().col(chosen_[static_cast<std::size_t>(k)]).data();
  };
  double* a = columns().col(column).data();
  double product = multiply(q(step), a, padded_rows_);
  for (; step + 1 < rank(); ++step) {
    r_(step, column) = product;
    product = subtractAndMultiply(product, q(step), q(step + 1), a, padded_rows_);
  }
  r_(step, column) = product;
  squared_norms_[column] = subtractAndSquare(product, q(step++), a, padded_rows_);
}

void ColumnElimination::settleAll() {
  for (Eigen::Index column = 0; column < squared_norms_.size(); ++column) settle(column);
}

Eigen::MatrixXd ColumnElimination::targetProducts() {
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
