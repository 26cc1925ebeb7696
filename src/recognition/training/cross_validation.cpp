#include "recognition/training/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "learning/reduction.h"
#include "learning/selection.h"
#include "recognition/training/learning_on.h"

namespace place_recognition {
namespace {

/// Those of `samples` that have the cue.
std::vector<int> withCue(const std::vector<int>& samples, const std::vector<int>& cue_rows) {
  std::vector<int> kept;
  for (const int sample : samples) {
    if (cue_rows[sample] >= 0) kept.push_back(sample);
  }
  return kept;
}

/// The largest value of each row in the columns `vectors`; 0 if there are none.
Eigen::VectorXd largestValues(const Eigen::MatrixXd& kernel_values,
                              const std::vector<int>& vectors) {
  if (vectors.empty()) return Eigen::VectorXd::Zero(kernel_values.rows());
  return pickColumns(kernel_values, vectors).rowwise().maxCoeff();
}

/// Weights of the samples' decision values in a reduction: they decrease each time a sample's place
/// is learned again.
Eigen::VectorXd importanceOf(const std::vector<int>& samples, const TrainingTask& task) {
  Eigen::VectorXd importance(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int age = task.samples[static_cast<std::size_t>(samples[i])].age;
    importance[static_cast<Eigen::Index>(i)] = std::pow(1 - task.forgetting, age);
  }
  return importance;
}

/// Extends the machines learned before by the rows `train_rows` of a Gram matrix, which belong to
/// `samples`. The machines of new places are trained on all of these, and then changed like others.
BinarySvms extendMachines(const LearnedCue& learned, const std::vector<int>& train_rows,
                          const std::vector<int>& samples, const PackedGram& gram,
                          const TrainingTask& task, const Progress& progress) {
  const auto before = static_cast<std::ptrdiff_t>(learned.machines.weights.rows());
  const std::vector<int> added(samples.begin() + before, samples.end());
  BinarySvms machines =
      learnOn(learned.machines, gram, train_rows, pickRows(learned.changes, added), 1 / task.svm.c);
  if (learned.new_places.empty()) return machines;

  const std::vector<int>& places = learned.new_places;
  std::vector<int> labels;  // numbers of new places; their count stands for all others
  for (const int sample : samples) {
    const auto place = std::find(places.begin(), places.end(), task.samples[sample].place);
    labels.push_back(static_cast<int>(place - places.begin()));
  }
  const BinarySvms trained =
      trainMachines(gram, train_rows, labels, places.size() + 1, task.svm, task.threads, progress);
  for (std::size_t k = 0; k < places.size(); ++k) {
    machines.weights.col(places[k]) += trained.weights.col(static_cast<Eigen::Index>(k));
    machines.biases[places[k]] = trained.biases[static_cast<Eigen::Index>(k)];
  }
  return machines;
}

/// Machines trained on (or extended by) the rows `train_rows` of a Gram matrix, which belong to
/// `samples`.
BinarySvms trainMachinesOn(const std::vector<int>& train_rows, const std::vector<int>& samples,
                           const PackedGram& gram, const TrainingTask& task,
                           const Progress& progress) {
  if (task.learned) {
    return extendMachines(*task.learned, train_rows, samples, gram, task, progress);
  }
  std::vector<int> labels;
  for (const int sample : samples) labels.push_back(task.samples[sample].place);
  return trainMachines(gram, train_rows, labels, task.places, task.svm, task.threads, progress);
}

/// trainReduced() on the rows `train_rows` of a Gram matrix, which belong to `samples`; the
/// resulting vectors are indices among these.
ReducedMachines trainReducedOn(const std::vector<int>& train_rows, const std::vector<int>& samples,
                               const PackedGram& gram, const TrainingTask& task,
                               const std::vector<ReductionOptions>& reductions,
                               const Progress& progress) {
  const BinarySvms machines = trainMachinesOn(train_rows, samples, gram, task, progress);
  const std::vector<int> vectors = supportVectors(machines);
  BinarySvms supported = machines;
  supported.weights = pickRows(machines.weights, vectors);
  Eigen::MatrixXd kernel_values = gram.values(train_rows, pick(train_rows, vectors));
  if (task.forgetting > 0) {
    kernel_values.array().colwise() *= importanceOf(samples, task).array();
  }
  return {vectors, reduceEach(supported, kernel_values, reductions, task.threads)};
}

}  // namespace

ReducedMachines trainReduced(const PackedGram& gram, const std::vector<int>& samples,
                             const TrainingTask& task,
                             const std::vector<ReductionOptions>& reductions) {
  std::vector<int> all(samples.size());
  std::iota(all.begin(), all.end(), 0);
  return trainReducedOn(all, samples, gram, task, reductions, task.progress);
}

std::vector<HeldOutValues> crossValidate(const PackedGram& gram, const std::vector<int>& cue_rows,
                                         const TrainingTask& task,
                                         const std::vector<ReductionOptions>& reductions,
                                         const Progress& progress) {
  std::vector<HeldOutValues> held_out(reductions.size(),
                                      HeldOutValues::none(task.samples.size(), task.places));
  for (std::size_t f = 0; f < task.folds.size(); ++f) {
    const Progress progress_of_fold = [&](const std::string&, double part) {
      const double done = static_cast<double>(f) + part;
      return !progress || progress("Validating", done / static_cast<double>(task.folds.size()));
    };
    const Fold& fold = task.folds[f];
    const std::vector<int> train = withCue(fold.train, cue_rows);
    const std::vector<int> test = withCue(fold.test, cue_rows);
    if (train.empty() || test.empty()) continue;
    std::vector<bool> trained(task.places, false);
    for (const int sample : train) trained[task.samples[sample].place] = true;

    const std::vector<int> train_rows = pick(cue_rows, train);
    const ReducedMachines reduced =
        trainReducedOn(train_rows, train, gram, task, reductions, progress_of_fold);
    const Eigen::MatrixXd kernel_values =
        gram.values(pick(cue_rows, test), pick(train_rows, reduced.vectors));
    for (std::size_t r = 0; r < reductions.size(); ++r) {
      const BinarySvms& machines = reduced.machines[r];
      const Eigen::MatrixXd decision_values =
          placeValues(machines, machines.decisionValues(kernel_values));
      const Eigen::VectorXd familiarity = largestValues(kernel_values, supportVectors(machines));
      for (std::size_t i = 0; i < test.size(); ++i) {
        if (!trained[task.samples[test[i]].place]) continue;
        const auto row = static_cast<Eigen::Index>(i);
        held_out[r].set(test[i], decision_values.row(row), familiarity[row]);
      }
    }
  }
  return held_out;
}

}  // namespace place_recognition
