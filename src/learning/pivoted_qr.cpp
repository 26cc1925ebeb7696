#include "learning/pivoted_qr.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// Columns are padded to a multiple of this: two registers of the widest instruction set.
constexpr Eigen::Index kPadding = 16;
constexpr std::size_t kTeam = ColumnTeam::kMost;

PLACE_RECOGNITION_TARGET_CLONES
void multiply(const double* x, double factor, Eigen::Index n, double* out) {
  for (Eigen::Index i = 0; i < n; ++i) out[i] = factor * x[i];
}

}  // namespace

PivotedQr::PivotedQr(Eigen::Index rows, Eigen::Index candidates, Eigen::Index targets)
    : rows_(rows),
      padded_rows_((rows + kPadding - 1) / kPadding * kPadding),
      candidates_(candidates),
      storage_(static_cast<std::size_t>(padded_rows_ * (candidates + targets)), 0),
      squared_norms_(Eigen::VectorXd::Zero(candidates + targets)),
      steps_(static_cast<std::size_t>(candidates + targets), 0),
      left_(steps_.size()),
      places_(steps_.size()),
      overlaps_(ColumnSteps::kMost, std::min(rows, candidates)),
      r_(Eigen::MatrixXd::Zero(std::min(rows, candidates), candidates + targets)) {
  std::iota(left_.begin(), left_.end(), Eigen::Index{0});
  std::iota(places_.begin(), places_.end(), std::size_t{0});
}

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
  for (int back = 1; back < ColumnSteps::kMost && back <= rank(); ++back) {
    overlaps_(back, rank()) = innerProduct(chosenColumn(rank() - back), q, padded_rows_);
  }
  chosen_.push_back(column);
}

void PivotedQr::update(Eigen::Index column) {
  if (isUpToDate(column)) return;
  Eigen::Index step = steps_[static_cast<std::size_t>(column)];
  Eigen::Index members[ColumnTeam::kMost];
  ColumnTeam team;
  const std::size_t begin = places_[static_cast<std::size_t>(column)] / kTeam * kTeam;
  for (std::size_t i = begin; i < std::min(begin + kTeam, left_.size()); ++i) {
    if (isUpToDate(left_[i])) continue;
    members[team.count] = left_[i];
    team.values[team.count] = columns().col(left_[i]).data();
    team.products[team.count++] = &r_(step, left_[i]);
  }
  while (step < rank()) {
    const ColumnSteps steps = stepsFrom(step);
    takeOut(steps, team, padded_rows_);
    for (int c = 0; c < team.count; ++c) team.products[c] += steps.count;
    step += steps.count;
  }
  for (int c = 0; c < team.count; ++c) {
    const double* a = team.values[c];
    squared_norms_[members[c]] = innerProduct(a, a, padded_rows_);
    steps_[static_cast<std::size_t>(members[c])] = step;
  }
}

void PivotedQr::updateAll() {
  for (Eigen::Index column = 0; column < squared_norms_.size(); ++column) update(column);
  left_.clear();
  for (Eigen::Index column = 0; column < squared_norms_.size(); ++column) {
    if (squared_norms_[column] == 0) continue;
    places_[static_cast<std::size_t>(column)] = left_.size();
    left_.push_back(column);
  }
}

ColumnSteps PivotedQr::stepsFrom(Eigen::Index first) {
  ColumnSteps steps;
  steps.count = static_cast<int>(std::min<Eigen::Index>(ColumnSteps::kMost, rank() - first));
  for (int s = 0; s < steps.count; ++s) {
    steps.q[s] = chosenColumn(first + s);
    for (int t = 0; t < s; ++t) steps.overlaps[s][t] = overlaps_(s - t, first + s);
  }
  return steps;
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
