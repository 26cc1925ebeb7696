#pragma once

#include <Eigen/Core>
#include <vector>

namespace place_recognition {

/// QR factorisation of the columns of a matrix in an order that the caller chooses step by step
/// (eq. 6.9: K P = Q R), by modified Gram-Schmidt: after each step every column is what is left of
/// it beyond the span of the chosen ones, so its norm is known afresh, and R is as accurate as by
/// Householder's transformations (Bjorck 1967). Q itself is not kept.
///
/// Columns from `candidates` on are right-hand sides F: never chosen, carried along, so that the
/// last columns of R become Q'F.
class ColumnElimination {
 public:
  ColumnElimination(Eigen::MatrixXd columns, Eigen::Index candidates);

  /// Makes candidate `column`, not yet chosen and with something left of it, the next one of Q.
  void choose(Eigen::Index column);

  /// Squared norms of what is left of each column; 0 for those chosen.
  const Eigen::VectorXd& squaredNorms() const { return squared_norms_; }
  /// (candidate, target): the products of what is left of them.
  Eigen::MatrixXd targetProducts() const;
  /// Candidates in the order of their choice.
  const std::vector<Eigen::Index>& chosen() const { return chosen_; }
  Eigen::Index candidates() const { return candidates_; }
  Eigen::Index rows() const { return columns_.rows(); }
  /// R, a row for each chosen column, columns in the order of the matrix.
  auto r() const { return r_.topRows(static_cast<Eigen::Index>(chosen_.size())); }

 private:
  Eigen::MatrixXd columns_;
  Eigen::Index candidates_;
  Eigen::VectorXd squared_norms_;
  std::vector<Eigen::Index> left_;  ///< columns not chosen
  std::vector<Eigen::Index> chosen_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> r_;
};

/// The X that solves R11 X = B, where R11 are the columns `chosen`, as many as the rows of B, of R.
Eigen::MatrixXd solveTriangular(const Eigen::MatrixXd& r, const std::vector<Eigen::Index>& chosen,
                                const Eigen::MatrixXd& b);

}  // namespace place_recognition
