#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "learning/binary_svms.h"
#include "learning/folds.h"
#include "learning/packed_gram.h"
#include "place_recognition/learning_options.h"
#include "place_recognition/progress.h"
#include "recognition/model/scores.h"

namespace place_recognition {

/// What one cue has learned before, see LearnedBefore.
struct LearnedCue {
  const BinarySvms& machines;      ///< over the first samples that have the cue
  const Eigen::MatrixXd& changes;  ///< samples x places
  const std::vector<int>& new_places;
};

/// The arguments that the trainings of all cues share.
struct TrainingTask {
  const std::vector<SampleOrigin>& samples;
  std::size_t places;
  const std::vector<Fold>& folds;  ///< of the samples
  const SvmOptions& svm;
  unsigned threads;
  const Progress& progress;
  std::uint64_t seed = 1;                  ///< of all random choices
  double forgetting = 0;                   ///< see IncrementalOptions
  std::optional<LearnedCue> learned = {};  ///< to extend; every fold trains on its vectors
};

/// Decision values of samples by machines that were trained without these samples and their
/// neighbours in time.
struct HeldOutValues {
  Eigen::MatrixXd decision_values;   ///< samples x places; zero if not valid
  std::vector<bool> valid;           ///< by sample: whether it has decision values
  Eigen::VectorXd familiarity = {};  ///< by sample: the largest kernel value
};

/// Binary SVMs after each of several reductions, over the support vectors before reduction.
struct ReducedMachines {
  std::vector<int> vectors;          ///< ascending, among the training vectors
  std::vector<BinarySvms> machines;  ///< over `vectors`, one per reduction
};

/// Trains on the Gram matrix of the training vectors, which belong to `samples`, and reduces; see
/// reduceEach() for the order of `reductions`.
ReducedMachines trainReduced(const PackedGram& gram, const std::vector<int>& samples,
                             const TrainingTask& task,
                             const std::vector<ReductionOptions>& reductions);

/// Computes held-out decision values of every sample of a cue by cross-validation, for each of
/// `reductions`. `gram` is the Gram matrix of the cue's features; `rows` maps each sample to its
/// row, -1 if the sample lacks the cue. A sample is not valid if it lacks the cue, is tested in no
/// fold, or if its own place could not be trained on in that fold. `progress`: of "Validating".
std::vector<HeldOutValues> crossValidate(const PackedGram& gram, const std::vector<int>& rows,
                                         const TrainingTask& task,
                                         const std::vector<ReductionOptions>& reductions,
                                         const Progress& progress = {});

/// Mean of the rooms' rates over the valid samples, by the largest decision value.
double averageRate(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places);

/// Standard error of that mean, as if frames were independent.
double averageRateError(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                        std::size_t places);

/// The pairs of places that the largest decision value confuses, over the valid samples.
std::vector<ConfusedPair> confusedPairs(const HeldOutValues& held_out,
                                        const std::vector<SampleOrigin>& samples,
                                        std::size_t places);

/// The loss -log(probability of the true place), in nats, of each of the `chosen` samples, after
/// calibration on the decision values of these same samples (one number, which a few hundred frames
/// determine well). It takes the certainty of the answers into account; the rate of a few hundred
/// frames only distinguishes right from wrong. A sample without decision values counts as uniform
/// probabilities. Probabilities count as at least a thousandth, so that no single frame decides.
std::vector<double> logLosses(const HeldOutValues& held_out,
                              const std::vector<SampleOrigin>& samples,
                              const std::vector<int>& chosen);

}  // namespace place_recognition
