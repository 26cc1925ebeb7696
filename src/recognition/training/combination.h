#pragma once

#include <vector>

#include "place_recognition/training_options.h"
#include "recognition/training/held_out_values.h"

namespace place_recognition {

// Cues are combined by the weighted mean of their decision values over the cues that an image has
// (discriminative accumulation); see CueMean.

/// The means over the cues.
struct CombinedValues : HeldOutValues {
  Eigen::MatrixXd unlimited = {};  ///< samples x places: decision values for the evidence
};

/// The limit of decision values for training with these options: 2 for several cues. A single cue
/// outvotes no other, and the decision values of one-against-one are numbers of votes.
double decisionLimit(const TrainingOptions& options);

/// Combines the held-out decision values and familiarity of the cues; valid if any cue with
/// positive weight is. `limit`: see Model::decision_limit.
CombinedValues combine(const std::vector<HeldOutValues>& cues, const std::vector<double>& weights,
                       double limit);

/// The weights in the options, scaled to sum 1.
std::vector<double> priorWeights(const std::vector<CueOptions>& cues);

/// Shares of the cues, each vector with sum 1: equal shares, followed by a grid of all shares in
/// steps of a tenth, coarser for many cues: at most 1001 vectors or, of more cues, one per cue.
std::vector<std::vector<double>> gridOfShares(std::size_t cues);

/// Chooses weights, with sum 1, by the rooms' mean rate on held-out samples. The result is the mean
/// of all settings within two standard errors of the best, because a few hundred frames cannot
/// distinguish them. The settings are multiples of `prior` by gridOfShares(). A cue whose weight in
/// this mean is less than a fifth of an equal share gets weight 0.
std::vector<double> chooseCueWeights(const std::vector<HeldOutValues>& cues,
                                     const std::vector<double>& prior, double limit,
                                     const std::vector<SampleOrigin>& samples, std::size_t places);

}  // namespace place_recognition
