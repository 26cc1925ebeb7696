#pragma once

#include <cstddef>
#include <vector>

#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// The reductions that `options` leave to choose from: themselves alone or, for the method auto,
/// none at all, then each method with falling fractions of the support vectors, as reduceEach()
/// likes them. Of more than 4000 samples, auto keeps every vector: factorizing their Gram matrices
/// in every fold would take far longer than the training itself.
std::vector<ReductionOptions> reductionsInQuestion(const ReductionOptions& options,
                                                   std::size_t samples);

/// The index of the one that keeps the fewest vectors at no loss: the log loss of held-out samples
/// (mean of the rooms, see logLosses()) is not above that of the first reduction, their rate is not
/// below, and so it is with every larger fraction by the same method. By the loss alone, or within
/// an error, it would choose smaller ones that cost several points of rate on another recording. Of
/// equal fractions, the smaller loss decides. `held_out`: one for each of `reductions`, of which
/// the first keeps most; it is the answer where no sample is valid.
std::size_t chooseReduction(const std::vector<ReductionOptions>& reductions,
                            const std::vector<HeldOutValues>& held_out,
                            const std::vector<SampleOrigin>& samples, std::size_t places);

}  // namespace place_recognition
