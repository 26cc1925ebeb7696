#include "recognition/training/learning_on.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>

namespace place_recognition {
namespace {

/// What the decision values of the added samples (rows) lack so that their own place leads by 1, at
/// +1 at most; other places give way only where that does not suffice.
Eigen::MatrixXd lackOf(const Eigen::MatrixXd& values, const std::vector<int>& labels) {
  constexpr double kLead = 1;
  Eigen::MatrixXd lack = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const Eigen::Index own = labels[static_cast<std::size_t>(i)];
    Eigen::RowVectorXd others = values.row(i);
    others[own] = -1;
    const double wanted = std::min(1.0, others.maxCoeff() + kLead);
    const double led = std::max(wanted, values(i, own));
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      lack(i, k) = k == own ? led - values(i, k) : std::min(0.0, led - kLead - values(i, k));
    }
  }
  return lack;
}

/// Solves A X = B for a symmetric A, which is positive definite for kernels that obey Mercer's
/// condition; the sigmoid kernel does not.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(a);
  if (cholesky.info() == Eigen::Success) return cholesky.solve(b);
  return a.ldlt().solve(b);
}

}  // namespace

BinarySvms learnOn(const BinarySvms& machines, const PackedGram& gram, const std::vector<int>& rows,
                   const std::vector<int>& labels, double ridge) {
  assert(!machines.one_against_one);
  const Eigen::Index before = machines.weights.rows();
  const std::vector<int> old(rows.begin(), rows.begin() + before);
  const std::vector<int> added(rows.begin() + before, rows.end());
  const std::vector<int> places(labels.begin() + before, labels.end());
  const Eigen::MatrixXd lack = lackOf(machines.decisionValues(gram.values(added, old)), places);

  std::vector<int> used = old;                       // rows of the Gram matrix
  std::vector<Eigen::Index> weights_of(old.size());  // rows of the weights
  for (Eigen::Index i = 0; i < before; ++i) weights_of[static_cast<std::size_t>(i)] = i;
  for (Eigen::Index i = 0; i < lack.rows(); ++i) {
    if (lack.row(i).isZero(0)) continue;
    used.push_back(added[static_cast<std::size_t>(i)]);
    weights_of.push_back(before + i);
  }
  const auto count = static_cast<Eigen::Index>(used.size());
  Eigen::MatrixXd targets = Eigen::MatrixXd::Zero(count, lack.cols());
  for (Eigen::Index i = before; i < count; ++i) {
    targets.row(i) = lack.row(weights_of[static_cast<std::size_t>(i)] - before);
  }
  Eigen::MatrixXd kernel = gram.values(used, used);
  kernel.diagonal().array() += ridge;
  const Eigen::MatrixXd change = solve(kernel, targets);

  BinarySvms learned = machines;
  learned.weights.conservativeResize(static_cast<Eigen::Index>(rows.size()), Eigen::NoChange);
  learned.weights.bottomRows(lack.rows()).setZero();
  for (Eigen::Index i = 0; i < count; ++i) {
    learned.weights.row(weights_of[static_cast<std::size_t>(i)]) += change.row(i);
  }
  return learned;
}

}  // namespace place_recognition
