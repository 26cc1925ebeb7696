#include "recognition/held_out.h"

#include "learning/reduction.h"
#include "recognition/scores.h"

namespace place_recognition {
namespace {

Eigen::MatrixXd columns(const Eigen::MatrixXd& matrix, const std::vector<int>& indices) {
  Eigen::MatrixXd part(matrix.rows(), static_cast<Eigen::Index>(indices.size()));
  for (std::size_t j = 0; j < indices.size(); ++j) part.col(j) = matrix.col(indices[j]);
  return part;
}

Eigen::MatrixXd rows(const Eigen::MatrixXd& matrix, const std::vector<int>& indices) {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(indices.size()), matrix.cols());
  for (std::size_t i = 0; i < indices.size(); ++i) part.row(i) = matrix.row(indices[i]);
  return part;
}

/// Those of `samples` that have the cue.
std::vector<int> withCue(const std::vector<int>& samples, const std::vector<int>& cue_rows) {
  std::vector<int> kept;
  for (const int sample : samples) {
    if (cue_rows[sample] >= 0) kept.push_back(sample);
  }
  return kept;
}

std::vector<int> rowsOf(const std::vector<int>& samples, const std::vector<int>& cue_rows) {
  std::vector<int> indices;
  for (const int sample : samples) indices.push_back(cue_rows[sample]);
  return indices;
}

/// True places of the valid samples, and those of their largest margins.
struct Answers {
  std::vector<int> truth, places;
};

Answers answersOf(const HeldOut& held_out, const std::vector<SampleOrigin>& samples) {
  Answers answers;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!held_out.valid[i]) continue;
    answers.truth.push_back(samples[i].place);
    answers.places.push_back(largest(held_out.margins.row(static_cast<Eigen::Index>(i))));
  }
  return answers;
}

}  // namespace

Machines trainReduced(const Eigen::MatrixXd& gram, const std::vector<int>& labels,
                      const TrainingTask& task, const ReductionOptions& reduction) {
  Machines machines = trainMachines(gram, labels, task.places, task.svm, task.threads);
  if (reduction.method == "none") return machines;

  const std::vector<int> vectors = supportVectors(machines);
  Machines supported = machines;
  supported.weights = rows(machines.weights, vectors);
  supported = reduce(supported, columns(gram, vectors), reduction);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    machines.weights.row(vectors[i]) = supported.weights.row(static_cast<Eigen::Index>(i));
  }
  machines.biases = supported.biases;
  return machines;
}

HeldOut heldOutMargins(const Eigen::MatrixXd& gram, const std::vector<int>& cue_rows,
                       const TrainingTask& task, const ReductionOptions& reduction) {
  HeldOut held_out;
  held_out.margins.setZero(static_cast<Eigen::Index>(task.samples.size()),
                           static_cast<Eigen::Index>(task.places));
  held_out.valid.assign(task.samples.size(), false);
  for (const Fold& fold : task.folds) {
    const std::vector<int> train = withCue(fold.train, cue_rows);
    const std::vector<int> test = withCue(fold.test, cue_rows);
    if (train.empty() || test.empty()) continue;
    std::vector<int> labels;
    std::vector<bool> trained(task.places, false);
    for (const int sample : train) {
      labels.push_back(task.samples[sample].place);
      trained[labels.back()] = true;
    }

    const std::vector<int> train_rows = rowsOf(train, cue_rows);
    const Eigen::MatrixXd train_columns = columns(gram, train_rows);
    const Machines machines =
        trainReduced(rows(train_columns, train_rows), labels, task, reduction);
    const Eigen::MatrixXd margins =
        placeMargins(machines, machines.margins(rows(train_columns, rowsOf(test, cue_rows))));
    for (std::size_t i = 0; i < test.size(); ++i) {
      if (!trained[task.samples[test[i]].place]) continue;
      held_out.margins.row(test[i]) = margins.row(static_cast<Eigen::Index>(i));
      held_out.valid[test[i]] = true;
    }
  }
  return held_out;
}

double averageRate(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places) {
  const Answers answers = answersOf(held_out, samples);
  return averageRate(answers.truth, answers.places, places);
}

double averageRateError(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                        std::size_t places) {
  const Answers answers = answersOf(held_out, samples);
  return averageRateError(answers.truth, answers.places, places);
}

}  // namespace place_recognition
