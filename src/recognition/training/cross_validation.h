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
#include "recognition/training/held_out_values.h"

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
/// `reductions`. `gram` is the Gram matrix of the cue's features; `cue_rows` maps each sample
/// to its row, -1 if the sample lacks the cue. A sample is not valid if it lacks the cue, is tested
/// in no fold, or if its own place could not be trained on in that fold. `progress`: of
/// "Validating".
std::vector<HeldOutValues> crossValidate(const PackedGram& gram, const std::vector<int>& cue_rows,
                                         const TrainingTask& task,
                                         const std::vector<ReductionOptions>& reductions,
                                         const Progress& progress = {});

}  // namespace place_recognition
