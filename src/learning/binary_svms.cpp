#include "learning/binary_svms.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/parallel.h"
#include "learning/libsvm_solver.h"

namespace place_recognition {
namespace {

/// Calls visit(machine, a, b) for every pair of places a < b, in the order of the machines.
template <typename Visit>
void forEachPair(std::size_t places, Visit visit) {
  Eigen::Index machine = 0;
  for (std::size_t a = 0; a < places; ++a) {
    for (std::size_t b = a + 1; b < places; ++b) {
      visit(machine++, static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
  }
}

/// For each machine, +1 or -1 for the vectors it is trained on, and 0 for the others.
std::vector<std::vector<int>> signsOfMachines(const std::vector<int>& labels, std::size_t places,
                                              bool one_against_one) {
  std::vector<std::vector<int>> signs;
  const auto add = [&](int positive, std::optional<int> negative) {
    std::vector<int>& machine = signs.emplace_back();
    for (const int label : labels) {
      const bool opposes = !negative || label == *negative;
      machine.push_back(label == positive ? 1 : opposes ? -1 : 0);
    }
  };
  if (one_against_one) {
    forEachPair(places, [&](Eigen::Index, Eigen::Index a, Eigen::Index b) {
      add(static_cast<int>(a), static_cast<int>(b));
    });
  } else {
    for (std::size_t place = 0; place < places; ++place) add(static_cast<int>(place), {});
  }
  return signs;
}

}  // namespace

Eigen::MatrixXd BinarySvms::decisionValues(const Eigen::MatrixXd& kernel_values) const {
  return (kernel_values * weights).rowwise() + biases;
}

std::size_t machineCount(std::size_t places, bool one_against_one) {
  return one_against_one ? places * (places - 1) / 2 : places;
}

Eigen::MatrixXd placeValues(const BinarySvms& machines, const Eigen::MatrixXd& machine_values) {
  if (!machines.one_against_one) return machine_values;
  const auto places = static_cast<Eigen::Index>(machines.places);
  Eigen::MatrixXd votes = Eigen::MatrixXd::Zero(machine_values.rows(), places);
  Eigen::MatrixXd sums = votes;
  forEachPair(machines.places, [&](Eigen::Index machine, Eigen::Index a, Eigen::Index b) {
    const auto decision_value = machine_values.col(machine);
    const Eigen::VectorXd for_a = (decision_value.array() > 0).cast<double>();
    votes.col(a) += for_a;
    votes.col(b).array() += 1 - for_a.array();
    sums.col(a) += decision_value;
    sums.col(b) -= decision_value;
  });
  return votes.array() + sums.array() / (3 * (sums.array().abs() + 1));
}

BinarySvms trainMachines(const PackedGram& gram, const std::vector<int>& vectors,
                         const std::vector<int>& labels, std::size_t places,
                         const SvmOptions& options, unsigned threads, const Progress& progress) {
  assert(vectors.size() == labels.size());
  options.check();
  BinarySvms machines;
  machines.places = places;
  machines.one_against_one = options.multiclass == "one-against-one";
  const auto signs = signsOfMachines(labels, places, machines.one_against_one);
  machines.weights.setZero(static_cast<Eigen::Index>(vectors.size()),
                           static_cast<Eigen::Index>(signs.size()));
  machines.biases.setZero(static_cast<Eigen::Index>(signs.size()));

  const LibsvmSolver solver(gram, vectors);
  parallelFor(signs.size(), threads, [&](std::size_t m, unsigned thread) {
    if (thread == 0) {
      report(progress, "Training", static_cast<double>(m) / static_cast<double>(signs.size()));
    }
    const auto machine = static_cast<Eigen::Index>(m);
    const bool positive = std::count(signs[m].begin(), signs[m].end(), 1) > 0;
    const bool negative = std::count(signs[m].begin(), signs[m].end(), -1) > 0;
    machines.biases[machine] =
        positive && negative ? solver.solve(signs[m], options.c, machines.weights.col(machine))
                             : (positive ? 1 : -1);
  });
  return machines;
}

BinarySvms trainMachines(const Eigen::MatrixXd& gram, const std::vector<int>& labels,
                         std::size_t places, const SvmOptions& options, unsigned threads) {
  assert(gram.rows() == gram.cols());
  std::vector<int> all(static_cast<std::size_t>(gram.rows()));
  std::iota(all.begin(), all.end(), 0);
  return trainMachines(PackedGram(gram), all, labels, places, options, threads);
}

std::vector<int> supportVectors(const BinarySvms& machines) {
  std::vector<int> indices;
  for (Eigen::Index i = 0; i < machines.weights.rows(); ++i) {
    if ((machines.weights.row(i).array() != 0).any()) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace place_recognition
