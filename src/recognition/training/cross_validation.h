#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "learning/binary_svms.h"
#include "learning/folds.h"
#include "learning/packed_gram.h"
#include "place_recognition/learning_options.h"
#include "place_recognition/progress.h"
#include "recognition/model/scores.h"

namespace place_recognition {

/// What the trainings of all cues have in common.
struct TrainingTask {
  const std::vector<SampleOrigin>& samples;
  std::size_t places;
  const std::vector<Fold>& folds;  ///< of the samples
  const SvmOptions& svm;
  unsigned threads;
  const Progress& progress;
  std::uint64_t seed = 1;  ///< of what is drawn at random
  double forgetting = 0;   ///< see IncrementalOptions
  /// One-against-all machines to learn on from, over the first samples that have the cue, which
  /// every fold trains on; null: there are none.
  const BinarySvms* learned = nullptr;
};

/// Decision values of samples by machines that were trained without them and their neighbours in
/// time.
struct HeldOutValues {
  Eigen::MatrixXd decision_values;   ///< samples x places; zero where there is none
  std::vector<bool> valid;           ///< of each sample: whether it has decision values
  Eigen::VectorXd familiarity = {};  ///< of each sample: the largest kernel value
};

/// Binary SVMs over the support vectors that they were trained to have, after each of some
/// reductions.
struct ReducedMachines {
  std::vector<int> vectors;          ///< ascending, among those trained on
  std::vector<BinarySvms> machines;  ///< over `vectors`, one for each reduction
};

/// Trains on the Gram matrix of the training vectors, which are of `samples`, and reduces; see
/// reduceEach() for the order of `reductions`.
ReducedMachines trainReduced(const PackedGram& gram, const std::vector<int>& samples,
                             const TrainingTask& task,
                             const std::vector<ReductionOptions>& reductions);

/// Held-out decision values of every sample of a cue by cross-validation, for each of `reductions`.
/// `gram` is the Gram matrix of the cue's features; `rows`: the row of each sample in it, -1 if the
/// sample lacks the cue. A sample is not valid if it lacks the cue, is tested in no fold, or if its
/// own place could not be trained on in that fold.
std::vector<HeldOutValues> crossValidate(const PackedGram& gram, const std::vector<int>& rows,
                                         const TrainingTask& task,
                                         const std::vector<ReductionOptions>& reductions);

/// Mean of the rooms' rates over the valid samples, by the largest decision value.
double averageRate(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places);

/// Standard error of that mean, as if frames were independent.
double averageRateError(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                        std::size_t places);

/// The pairs of places that the largest decision value takes for one another, over the valid
/// samples.
std::vector<ConfusedPair> confusedPairs(const HeldOutValues& held_out,
                                        const std::vector<SampleOrigin>& samples,
                                        std::size_t places);

/// -log of the probability given to the true place, in nats, for each of `chosen` samples, after
/// calibration on the decision values of these very samples (one number, which a few hundred frames
/// determine well). Uses how sure the answers are, where a rate of a few hundred frames only knows
/// right and wrong. A sample without decision values counts as an answer that knows nothing; no
/// probability counts as less than a thousandth, so that no single frame decides.
std::vector<double> logLosses(const HeldOutValues& held_out,
                              const std::vector<SampleOrigin>& samples,
                              const std::vector<int>& chosen);

}  // namespace place_recognition
