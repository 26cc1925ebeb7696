#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "learning/kernel.h"

struct svm_node;

namespace place_recognition {

/// Kernel values of n features (rows) with the first m of them (columns), 8 bytes per value, in the
/// layout that libsvm reads: machines are trained on any subset of the features without a copy.
/// Immutable.
///
/// libsvm reads a row of a precomputed kernel as nodes {int index; double value} of 16 bytes each,
/// and never reads the indices. Two rows therefore share their memory: the values of one are stored
/// where the other has its indices.
class PackedGram {
 public:
  /// Computes kernel.value() of `measures`, n x m with m <= n, in parallel.
  PackedGram(const Kernel& kernel, const Eigen::MatrixXd& measures, unsigned threads);
  /// Stores the values as given.
  PackedGram(const Eigen::MatrixXd& values);

  Eigen::Index rows() const { return rows_; }
  Eigen::Index columns() const { return columns_; }
  double operator()(Eigen::Index row, Eigen::Index column) const {
    return rowStart(row)[2 * column + 3];
  }
  /// The values in the given rows and columns.
  Eigen::MatrixXd values(const std::vector<int>& rows, const std::vector<int>& columns) const;

  /// A row for libsvm: the node with its number, from 1, then one node per column. libsvm must not
  /// write to it.
  svm_node* nodes(Eigen::Index row) const;

 private:
  template <typename Value>
  void fill(const Eigen::MatrixXd& source, unsigned threads, Value value);
  /// Start of the nodes of a row; the value of node k is at 2k + 1.
  double* rowStart(Eigen::Index row) const {
    return memory_.get() + row / 2 * pairSize() + row % 2;
  }
  /// Number of doubles that two rows share.
  Eigen::Index pairSize() const { return 2 * (columns_ + 1) + 2; }

  Eigen::Index rows_;
  Eigen::Index columns_;
  std::unique_ptr<double[]> memory_;
};

}  // namespace place_recognition
