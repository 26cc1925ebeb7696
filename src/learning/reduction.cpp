#include "learning/reduction.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "learning/column_choice.h"
#include "learning/column_elimination.h"

namespace place_recognition {
namespace {

using Indices = std::vector<int>;

Eigen::MatrixXd pickColumns(const Eigen::MatrixXd& matrix, const Indices& indices) {
  Eigen::MatrixXd picked(matrix.rows(), indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    picked.col(static_cast<Eigen::Index>(i)) = matrix.col(indices[i]);
  }
  return picked;
}

/// What columns are divided by before they are factorised; never 0.
Eigen::RowVectorXd columnScales(const Eigen::MatrixXd& columns, bool normalise) {
  Eigen::RowVectorXd scales = Eigen::RowVectorXd::Ones(columns.cols());
  if (normalise) scales = columns.colwise().norm();
  return (scales.array() > 0).select(scales, 1);
}

ChoiceLimits limitsOf(const ReductionOptions& options, const ColumnElimination& elimination) {
  const Eigen::Index most = std::min(elimination.candidates(), elimination.rows());
  if (options.support_vectors == 0) return {options.tau, most};
  return {0, std::min<Eigen::Index>(most, options.support_vectors)};
}

/// One machine's support vectors, factorised as far as any reduction may need them.
struct MachineFactors {
  Indices vectors;
  Eigen::RowVectorXd scales;
  std::vector<Eigen::Index> chosen;  ///< among `vectors`
  Eigen::VectorXd pivots;            ///< relative to the first
  Eigen::MatrixXd r;
};

Indices vectorsOf(const Machines& machines, Eigen::Index machine) {
  Indices vectors;
  for (Eigen::Index i = 0; i < machines.weights.rows(); ++i) {
    if (machines.weights(i, machine) != 0) vectors.push_back(static_cast<int>(i));
  }
  return vectors;
}

MachineFactors factorise(const Indices& vectors, const Eigen::MatrixXd& kernel_values,
                         const ReductionOptions& options, const Progress& progress) {
  MachineFactors factors;
  factors.vectors = vectors;
  Eigen::MatrixXd columns = pickColumns(kernel_values, vectors);
  factors.scales = columnScales(columns, options.normalise);
  columns.array().rowwise() /= factors.scales.array();
  const Eigen::Index m = columns.cols();
  ColumnElimination elimination(std::move(columns), m);
  const ChoiceLimits limits = limitsOf(options, elimination);
  factors.pivots = chooseByPivot(elimination, limits, progress);
  factors.chosen = elimination.chosen();
  factors.r = elimination.r();
  return factors;
}

/// For each machine how many of its chosen vectors are kept so that, with one tau for all machines,
/// at most `max_vectors` different ones remain.
std::vector<Eigen::Index> ranksFor(const std::vector<MachineFactors>& machines, int max_vectors) {
  struct Candidate {
    double pivot;
    std::size_t machine;
    int vector;
  };
  std::vector<Candidate> candidates;
  for (std::size_t m = 0; m < machines.size(); ++m) {
    for (Eigen::Index k = 0; k < machines[m].pivots.size(); ++k) {
      candidates.push_back({machines[m].pivots[k], m, machines[m].vectors[machines[m].chosen[k]]});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.pivot > b.pivot; });
  std::vector<Eigen::Index> ranks(machines.size(), 0);
  std::set<int> kept;
  for (const Candidate& candidate : candidates) {
    kept.insert(candidate.vector);
    if (static_cast<int>(kept.size()) > max_vectors) break;
    ++ranks[candidate.machine];
  }
  return ranks;
}

/// Eq. 6.21: the weights of the first `rank` chosen vectors, into a column of zeros.
void updateWeights(const MachineFactors& factors, Eigen::Index rank,
                   const Eigen::Ref<const Eigen::VectorXd>& weights,
                   Eigen::Ref<Eigen::VectorXd> reduced) {
  const std::vector<Eigen::Index> independent(factors.chosen.begin(),
                                              factors.chosen.begin() + rank);
  Eigen::VectorXd dependent(factors.vectors.size());  // D2 alpha_2
  for (Eigen::Index i = 0; i < dependent.size(); ++i) {
    dependent[i] = factors.scales[i] * weights[factors.vectors[i]];
  }
  for (const Eigen::Index i : independent) dependent[i] = 0;
  const Eigen::VectorXd update =  // R11^-1 R12 D2 alpha_2
      solveTriangular(factors.r, independent, factors.r.topRows(rank) * dependent);
  for (Eigen::Index k = 0; k < rank; ++k) {
    const int vector = factors.vectors[independent[k]];
    reduced[vector] = weights[vector] + update[k] / factors.scales[independent[k]];
  }
}

/// Each machine by itself, with the same tau (section 6.3).
Eigen::MatrixXd reduceEach(const Machines& machines, const Eigen::MatrixXd& kernel_values,
                           const ReductionOptions& options, const Progress& progress) {
  const Eigen::Index count = machines.weights.cols();
  std::vector<MachineFactors> factors;
  std::vector<Eigen::Index> ranks;
  for (Eigen::Index m = 0; m < count; ++m) {
    const Progress part = [&](const std::string& stage, double fraction) {
      return !progress || progress(stage, (static_cast<double>(m) + fraction) / count);
    };
    factors.push_back(factorise(vectorsOf(machines, m), kernel_values, options, part));
    ranks.push_back(factors.back().pivots.size());
  }
  if (options.support_vectors > 0) ranks = ranksFor(factors, options.support_vectors);

  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(machines.weights.rows(), count);
  for (Eigen::Index m = 0; m < count; ++m) {
    updateWeights(factors[m], ranks[m], machines.weights.col(m), weights.col(m));
  }
  return weights;
}

/// One basis for all machines; weights by least squares to the margins F = K A without bias.
Eigen::MatrixXd reduceShared(const Machines& machines, const Eigen::MatrixXd& kernel_values,
                             const ReductionOptions& options, const Progress& progress) {
  const Indices vectors = supportVectors(machines);
  Eigen::MatrixXd columns = pickColumns(kernel_values, vectors);
  const Eigen::RowVectorXd scales = columnScales(columns, options.normalise);
  columns.array().rowwise() /= scales.array();
  const Eigen::Index m = columns.cols();
  columns.conservativeResize(Eigen::NoChange, m + machines.weights.cols());
  columns.rightCols(machines.weights.cols()) = kernel_values * machines.weights;

  ColumnElimination elimination(std::move(columns), m);
  const ChoiceLimits limits = limitsOf(options, elimination);
  if (options.method == "shared-qr") {
    chooseByPivot(elimination, limits, progress);
  } else {
    chooseByFit(elimination, limits, progress);
  }
  const std::vector<Eigen::Index>& basis = elimination.chosen();
  const Eigen::MatrixXd fitted =
      solveTriangular(elimination.r(), basis, elimination.r().rightCols(machines.weights.cols()));
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(machines.weights.rows(), machines.weights.cols());
  for (std::size_t k = 0; k < basis.size(); ++k) {
    weights.row(vectors[basis[k]]) = fitted.row(static_cast<Eigen::Index>(k)) / scales[basis[k]];
  }
  return weights;
}

}  // namespace

Machines reduce(const Machines& machines, const Eigen::MatrixXd& kernel_values,
                const ReductionOptions& options, const Progress& progress) {
  options.check();
  assert(kernel_values.cols() == machines.weights.rows());
  if (options.method == "none" || supportVectors(machines).empty()) return machines;
  Machines reduced = machines;
  reduced.weights = options.method == "qr"
                        ? reduceEach(machines, kernel_values, options, progress)
                        : reduceShared(machines, kernel_values, options, progress);
  return reduced;
}

}  // namespace place_recognition
