#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/huge_pages.h"

namespace place_recognition {

/// QR factorization of the columns of a matrix in an order that the caller chooses step by step
/// (eq. 6.9: K P = Q R), by modified Gram-Schmidt: each step subtracts from the other columns their
/// component along the chosen one and computes their norms anew. R is as accurate as with
/// Householder transformations (Bjorck 1967). A column's step may be deferred until its norm is
/// needed, because the norm can only decrease. Gives the same bits on every machine.
///
/// The candidates are followed by targets, the right-hand sides F: they are never chosen but
/// updated as well, so that the last columns of R become Q'F.
class PivotedQr {
 public:
  /// Starts with zero columns, which must be set before anything else.
  PivotedQr(Eigen::Index rows, Eigen::Index candidates, Eigen::Index targets);

  /// Column `column` = values / scale.
  void set(Eigen::Index column, const Eigen::Ref<const Eigen::VectorXd>& values, double scale);

  /// Makes candidate `column`, which must be up to date and not zero, the next column of Q.
  void choose(Eigen::Index column);

  /// Applies all steps so far to a column, or to all of them.
  void update(Eigen::Index column);
  void updateAll();
  /// A column that is zero or chosen is always up to date.
  bool isUpToDate(Eigen::Index column) const {
    return squared_norms_[column] == 0 || steps_[static_cast<std::size_t>(column)] == rank();
  }

  /// Squared norms of the remainders of the columns; for a column that is not up to date, of its
  /// last update. 0 for chosen columns.
  const Eigen::VectorXd& squaredNorms() const { return squared_norms_; }
  /// (candidate, target): inner products of the remainders. All columns must be up to date.
  Eigen::MatrixXd targetProducts();

  Eigen::Index rows() const { return rows_; }
  Eigen::Index candidates() const { return candidates_; }
  Eigen::Index rank() const { return static_cast<Eigen::Index>(chosen_.size()); }
  /// Candidates in the order in which they were chosen.
  const std::vector<Eigen::Index>& chosen() const { return chosen_; }
  /// R, one row per chosen column; its columns are in the order of the matrix. All must be up to
  /// date.
  auto r() const { return r_.topRows(rank()); }

 private:
  using Columns = Eigen::Map<Eigen::MatrixXd>;
  Columns columns() { return {storage_.data(), padded_rows_, squared_norms_.size()}; }

  Eigen::Index rows_;
  Eigen::Index padded_rows_;  ///< with zero padding, so that every column starts on a cache line
  Eigen::Index candidates_;
  /// The remainder of each column; for a chosen one, the unit vector of Q.
  HugeVector<double> storage_;
  Eigen::VectorXd squared_norms_;
  std::vector<Eigen::Index> chosen_;
  std::vector<Eigen::Index> steps_;  ///< number of steps applied to each column
  Eigen::MatrixXd r_;
};

/// Solves R11 X = B for X, where R11 consists of the columns `chosen` of R, as many as B has rows.
Eigen::MatrixXd solveTriangular(const Eigen::MatrixXd& r, const std::vector<Eigen::Index>& chosen,
                                const Eigen::MatrixXd& b);

}  // namespace place_recognition
