#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/huge_pages.h"

namespace place_recognition {

/// QR factorization of the columns of a matrix in an order that the caller chooses step by step
/// (eq. 6.9: K P = Q R), by modified Gram-Schmidt: each step takes out of the other columns their
/// part along the chosen one, so that their norms are known afresh; R is as accurate as by
/// Householder's transformations (Bjorck 1967). What a step does to a column may wait until that
/// column is brought up to date, for its norm can only fall. Same bits on every machine.
///
/// Behind the candidates stand targets, right-hand sides F: never chosen, carried along, so that
/// the last columns of R become Q'F.
class PivotedQr {
 public:
  /// Starts with columns of zeros, which are to be set before anything else.
  PivotedQr(Eigen::Index rows, Eigen::Index candidates, Eigen::Index targets);

  /// Column `column` = values / scale.
  void set(Eigen::Index column, const Eigen::Ref<const Eigen::VectorXd>& values, double scale);

  /// Makes candidate `column`, up to date and with something left of it, the next one of Q.
  void choose(Eigen::Index column);

  /// Brings a column, or all of them, up to the last step.
  void update(Eigen::Index column);
  void updateAll();
  /// Also if nothing is left of it, or it is chosen.
  bool isUpToDate(Eigen::Index column) const {
    return squared_norms_[column] == 0 || steps_[static_cast<std::size_t>(column)] == rank();
  }

  /// Squared norms of what is left of each column; of one that is not up to date, what was left
  /// when it was. 0 for those chosen.
  const Eigen::VectorXd& squaredNorms() const { return squared_norms_; }
  /// (candidate, target): the products of what is left of them. All must be up to date.
  Eigen::MatrixXd targetProducts();

  Eigen::Index rows() const { return rows_; }
  Eigen::Index candidates() const { return candidates_; }
  Eigen::Index rank() const { return static_cast<Eigen::Index>(chosen_.size()); }
  /// Candidates in the order of their choice.
  const std::vector<Eigen::Index>& chosen() const { return chosen_; }
  /// R, a row for each chosen column, columns in the order of the matrix. All must be up to date.
  auto r() const { return r_.topRows(rank()); }

 private:
  using Columns = Eigen::Map<Eigen::MatrixXd>;
  Columns columns() { return {storage_.data(), padded_rows_, squared_norms_.size()}; }

  Eigen::Index rows_;
  Eigen::Index padded_rows_;  ///< with zeros, so that every column starts on a cache line
  Eigen::Index candidates_;
  /// What is left of each column; where it is chosen, the unit vector of Q.
  HugeVector<double> storage_;
  Eigen::VectorXd squared_norms_;
  std::vector<Eigen::Index> chosen_;
  std::vector<Eigen::Index> steps_;  ///< how many steps each column has seen
  Eigen::MatrixXd r_;
};

/// The X that solves R11 X = B, where R11 are the columns `chosen`, as many as the rows of B, of R.
Eigen::MatrixXd solveTriangular(const Eigen::MatrixXd& r, const std::vector<Eigen::Index>& chosen,
                                const Eigen::MatrixXd& b);

}  // namespace place_recognition
