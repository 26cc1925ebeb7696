#pragma once

#include <Eigen/Dense>
#include <vector>

namespace place_recognition {

/// Returns the reduced weights of one machine: eq. 6.18 to 6.21 with Eigen's Householder
/// transformations, as in the thesis. `gram` holds the kernel values of all vectors with each
/// other, `weights` one weight per vector; vectors of weight 0 are not the machine's.
inline Eigen::VectorXd thesisReduction(const Eigen::MatrixXd& gram, const Eigen::VectorXd& weights,
                                       double tau, bool normalize) {
  std::vector<Eigen::Index> vectors;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (weights[i] != 0) vectors.push_back(i);
  }
  const auto m = static_cast<Eigen::Index>(vectors.size());
  Eigen::MatrixXd k(gram.rows(), m);
  Eigen::VectorXd alpha(m);
  for (Eigen::Index j = 0; j < m; ++j) {
    k.col(j) = gram.col(vectors[static_cast<std::size_t>(j)]);
    alpha[j] = weights[vectors[static_cast<std::size_t>(j)]];
  }
  Eigen::RowVectorXd scales = Eigen::RowVectorXd::Ones(m);
  if (normalize) {
    scales = k.colwise().norm();
    scales[0] *= 1 - 1e-9;  // breaks the tie of equal norms in favour of the first
    k.array().rowwise() /= scales.array();
    alpha.array() *= scales.transpose().array();
  }

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(k);
  qr.setThreshold(tau);
  const Eigen::Index r = qr.rank();
  const Eigen::VectorXd permuted = qr.colsPermutation().transpose() * alpha;
  const Eigen::VectorXd updated =
      permuted.head(r) + qr.matrixR().topLeftCorner(r, r).triangularView<Eigen::Upper>().solve(
                             qr.matrixR().topRightCorner(r, m - r) * permuted.tail(m - r));
  Eigen::VectorXd reduced = Eigen::VectorXd::Zero(weights.size());
  for (Eigen::Index i = 0; i < r; ++i) {
    const Eigen::Index j = qr.colsPermutation().indices()[i];
    reduced[vectors[static_cast<std::size_t>(j)]] = updated[i] / scales[j];
  }
  return reduced;
}

}  // namespace place_recognition
