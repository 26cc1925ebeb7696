#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "learning/kernel.h"

struct svm_node;

namespace place_recognition {

/// Kernel values of n features (rows) with the first m of them (columns), 8 bytes a value, as
/// libsvm reads them: machines are trained on any of the features without a copy. Immutable.
///
/// libsvm takes a row of a precomputed kernel as nodes {int index; double value}, 16 bytes each,
/// and never reads their indices. So two rows share their memory: where one has its values, the
/// other has its indices.
class PackedGram {
 public:
  /// kernel.value() of `measures`, n x m with m <= n, in parallel.
  PackedGram(const Kernel& kernel, const Eigen::MatrixXd& measures, unsigned threads);
  /// The values themselves.
  PackedGram(const Eigen::MatrixXd& values);

  Eigen::Index rows() const { return rows_; }
  Eigen::Index columns() const { return columns_; }
  double operator()(Eigen::Index row, Eigen::Index column) const {
    return rowStart(row)[2 * column + 3];
  }
  /// The values of some rows in some columns.
  Eigen::MatrixXd values(const std::vector<int>& rows, const std::vector<int>& columns) const;

  /// A row as libsvm wants it: the node of its number, from 1, then a node for each column. It must
  /// not write to it.
  svm_node* nodes(Eigen::Index row) const;

 private:
  template <typename Value>
  void fill(const Eigen::MatrixXd& source, unsigned threads, Value value);
  /// Where the nodes of a row start; the value of node k stands at 2k + 1.
  double* rowStart(Eigen::Index row) const {
    return memory_.get() + row / 2 * pairSize() + row % 2;
  }
  /// Doubles that two rows share.
  Eigen::Index pairSize() const { return 2 * (columns_ + 1) + 2; }

  Eigen::Index rows_;
  Eigen::Index columns_;
  std::unique_ptr<double[]> memory_;
};

}  // namespace place_recognition
