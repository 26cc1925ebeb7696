#include "recognition/training/learning_on.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <functional>

namespace place_recognition {
namespace {

/// What the own place of a frame has to rise to: the others, which are to follow by `lead`, fall by
/// as much as it rises.
double raised(double own, std::vector<double> others, double lead) {
  std::sort(others.begin(), others.end(), std::greater<double>());
  double sum = own;
  double result = own;
  for (std::size_t n = 0; n < others.size() && others[n] + lead > result; ++n) {
    sum += others[n] + lead;
    result = sum / static_cast<double>(n + 2);
  }
  return result;
}

/// Solves A X = B for a symmetric A, which is positive definite for kernels that obey Mercer's
/// condition; the sigmoid kernel does not.
Eigen::MatrixXd solve(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(a);
  if (cholesky.info() == Eigen::Success) return cholesky.solve(b);
  return a.ldlt().solve(b);
}

}  // namespace

Eigen::MatrixXd changesToLead(const Eigen::MatrixXd& decision_values,
                              const std::vector<int>& labels, const std::vector<double>& leads) {
  assert(decision_values.rows() == static_cast<Eigen::Index>(labels.size()));
  Eigen::MatrixXd changes(decision_values.rows(), decision_values.cols());
  for (Eigen::Index i = 0; i < changes.rows(); ++i) {
    const Eigen::Index own = labels[static_cast<std::size_t>(i)];
    const double lead = leads[static_cast<std::size_t>(i)];
    std::vector<double> others;
    for (Eigen::Index k = 0; k < changes.cols(); ++k) {
      if (k != own) others.push_back(decision_values(i, k));
    }
    const double led = raised(decision_values(i, own), std::move(others), lead);
    changes.row(i) = (led - lead - decision_values.row(i).array()).min(0);
    changes(i, own) = led - decision_values(i, own);
  }
  return changes;
}

BinarySvms learnOn(const BinarySvms& machines, const PackedGram& gram, const std::vector<int>& rows,
                   const Eigen::MatrixXd& changes, double ridge) {
  assert(!machines.one_against_one);
  const Eigen::Index before = machines.weights.rows();
  assert(before + changes.rows() == static_cast<Eigen::Index>(rows.size()));

  std::vector<int> used(rows.begin(), rows.begin() + before);  // rows of the Gram matrix
  std::vector<Eigen::Index> weights_of;                        // rows of the weights
  for (Eigen::Index i = 0; i < before; ++i) weights_of.push_back(i);
  for (Eigen::Index i = 0; i < changes.rows(); ++i) {
    if (changes.row(i).isZero(0)) continue;
    used.push_back(rows[static_cast<std::size_t>(before + i)]);
    weights_of.push_back(before + i);
  }
  const auto count = static_cast<Eigen::Index>(used.size());
  Eigen::MatrixXd targets = Eigen::MatrixXd::Zero(count, changes.cols());
  for (Eigen::Index i = before; i < count; ++i) {
    targets.row(i) = changes.row(weights_of[static_cast<std::size_t>(i)] - before);
  }
  Eigen::MatrixXd kernel = gram.values(used, used);
  kernel.diagonal().array() += ridge;
  const Eigen::MatrixXd added = solve(kernel, targets);

  BinarySvms learned = machines;
  learned.weights.conservativeResize(static_cast<Eigen::Index>(rows.size()), Eigen::NoChange);
  learned.weights.bottomRows(changes.rows()).setZero();
  for (Eigen::Index i = 0; i < count; ++i) {
    learned.weights.row(weights_of[static_cast<std::size_t>(i)]) += added.row(i);
  }
  return learned;
}

}  // namespace place_recognition
