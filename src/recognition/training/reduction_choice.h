#pragma once

#include <cstddef>
#include <vector>

#include "recognition/training/combination.h"

namespace place_recognition {

/// The candidate reductions of `options`: only themselves or, for the method auto, no reduction,
/// then each method with decreasing fractions of the support vectors, in the order that
/// reduceEach() prefers. With more than 4000 samples, auto keeps every vector: factorizing their
/// Gram matrices in every fold would take far longer than the training itself.
std::vector<ReductionOptions> reductionsInQuestion(const ReductionOptions& options,
                                                   std::size_t samples);

/// The index of the reduction that keeps the fewest vectors without loss: its log loss on held-out
/// samples (mean of the rooms, see logLosses()) is not above that of the first reduction, its rate
/// is not below, and the same holds for every larger fraction of the same method. Less strict
/// criteria (the loss alone, or a tolerance of one standard error) choose smaller sets that cost
/// several points of rate on another recording. Of equal fractions, the smaller loss decides.
/// `held_out`: one for each of `reductions`, of which the first keeps most vectors; it is the
/// result unless at least five samples of every place are valid: a place that no sample speaks for
/// would lose its vectors.
std::size_t chooseReduction(const std::vector<ReductionOptions>& reductions,
                            const std::vector<CombinedValues>& held_out,
                            const std::vector<SampleOrigin>& samples, std::size_t places);

}  // namespace place_recognition
