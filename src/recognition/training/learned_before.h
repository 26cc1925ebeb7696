#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/binary_svms.h"
#include "place_recognition/model.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// What incremental training keeps instead of training from nothing.
struct LearnedBefore {
  std::vector<BinarySvms> machines;  ///< of each cue, over the remembered samples that have it
  /// Samples x places: the change of decision values that each sample asks for; zero for the
  /// remembered ones.
  Eigen::MatrixXd changes;
  std::vector<int> new_places;  ///< whose machines are still to be trained
};

/// The machines of `model`, extended to the places of `samples`, which begin with the remembered
/// samples of the model. The other samples ask for the smallest change after which the sum of all
/// cues finds their own place nine times as probable as any other; if they show all places, after
/// which their own place leads by 2. For the changes, a new place is taken to have a decision value
/// of +1 for its own samples and -1 for others. Precondition: the machines are one-against-all.
LearnedBefore learnedBefore(const Model& model, const Samples& samples);

}  // namespace place_recognition
