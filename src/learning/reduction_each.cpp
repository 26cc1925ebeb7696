#include <algorithm>
#include <set>

#include "learning/reduction_task.h"

namespace place_recognition {
namespace {

/// One machine's support vectors, factorized as far as its reduction may require.
struct MachineFactors {
  std::vector<int> vectors;
  std::vector<Eigen::Index> chosen;  ///< indices into `vectors`, in the order of the pivots
  Eigen::VectorXd pivots;            ///< relative to the first
  Eigen::MatrixXd r;

  int chosenVector(Eigen::Index k) const {
    return vectors[static_cast<std::size_t>(chosen[static_cast<std::size_t>(k)])];
  }
};

MachineFactors factorizeMachine(const ReductionTask& task, Eigen::Index machine) {
  MachineFactors factors;
  for (Eigen::Index i = 0; i < task.machines.weights.rows(); ++i) {
    if (task.machines.weights(i, machine) != 0) factors.vectors.push_back(static_cast<int>(i));
  }
  const auto m = static_cast<Eigen::Index>(factors.vectors.size());
  PivotedQr qr(task.kernel_values.rows(), m, 0);
  for (Eigen::Index i = 0; i < m; ++i) {
    const int vector = factors.vectors[static_cast<std::size_t>(i)];
    qr.set(i, task.kernel_values.col(vector), task.scales[vector]);
  }
  const Progress progress = [&](const std::string& stage, double fraction) {
    const auto machines = static_cast<double>(task.machines.weights.cols());
    return !task.progress ||
           task.progress(stage, (static_cast<double>(machine) + fraction) / machines);
  };
  factors.pivots = chooseByPivot(qr, task.limitsFor(qr), progress);
  factors.chosen = qr.chosen();
  factors.r = qr.r();
  return factors;
}

/// For each machine, the number of its chosen vectors to keep so that, with one tau for all
/// machines, at most `max_vectors` different ones remain.
std::vector<Eigen::Index> ranksFor(const std::vector<MachineFactors>& machines, int max_vectors) {
  struct Candidate {
    double pivot;
    std::size_t machine;
    int vector;
  };
  std::vector<Candidate> candidates;
  for (std::size_t m = 0; m < machines.size(); ++m) {
    for (Eigen::Index k = 0; k < machines[m].pivots.size(); ++k) {
      candidates.push_back({machines[m].pivots[k], m, machines[m].chosenVector(k)});
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

/// Eq. 6.21 for the first `rank` chosen vectors; the weights of the others are 0.
Eigen::VectorXd updatedWeights(const MachineFactors& factors, Eigen::Index rank,
                               const Eigen::VectorXd& weights, const Eigen::RowVectorXd& scales) {
  const std::vector<Eigen::Index> independent(factors.chosen.begin(),
                                              factors.chosen.begin() + rank);
  Eigen::VectorXd dependent(factors.r.cols());  // alpha_2 of the scaled columns
  for (Eigen::Index i = 0; i < dependent.size(); ++i) {
    const int vector = factors.vectors[static_cast<std::size_t>(i)];
    dependent[i] = weights[vector] * scales[vector];
  }
  for (const Eigen::Index i : independent) dependent[i] = 0;
  const Eigen::VectorXd update =  // R11^-1 R12 alpha_2
      solveTriangular(factors.r, independent, factors.r.topRows(rank) * dependent);

  Eigen::VectorXd updated = Eigen::VectorXd::Zero(weights.size());
  for (Eigen::Index k = 0; k < rank; ++k) {
    const int vector = factors.chosenVector(k);
    updated[vector] = weights[vector] + update[k] / scales[vector];
  }
  return updated;
}

class EachReduction : public Reduction {
 public:
  explicit EachReduction(const ReductionTask& task)
      : machines_(task.machines), scales_(task.scales) {
    for (Eigen::Index m = 0; m < machines_.weights.cols(); ++m) {
      factors_.push_back(factorizeMachine(task, m));
    }
  }

  BinarySvms withVectors(int count) const override { return withRanks(ranksFor(factors_, count)); }

  BinarySvms withTau(double tau) const override {
    std::vector<Eigen::Index> ranks;
    for (const MachineFactors& machine : factors_) ranks.push_back(rankAt(machine.pivots, tau));
    return withRanks(ranks);
  }

  std::vector<double> thresholds() const override {
    std::vector<double> all;
    for (const MachineFactors& machine : factors_) {
      all.insert(all.end(), machine.pivots.data(), machine.pivots.data() + machine.pivots.size());
    }
    std::sort(all.rbegin(), all.rend());
    return all;
  }

 private:
  BinarySvms withRanks(const std::vector<Eigen::Index>& ranks) const {
    BinarySvms reduced = machines_;
    for (Eigen::Index m = 0; m < reduced.weights.cols(); ++m) {
      const auto i = static_cast<std::size_t>(m);
      reduced.weights.col(m) =
          updatedWeights(factors_[i], ranks[i], machines_.weights.col(m), scales_);
    }
    return reduced;
  }

  BinarySvms machines_;
  Eigen::RowVectorXd scales_;
  std::vector<MachineFactors> factors_;
};

}  // namespace

std::unique_ptr<const Reduction> factorizeEach(const ReductionTask& task) {
  return std::make_unique<EachReduction>(task);
}

}  // namespace place_recognition
