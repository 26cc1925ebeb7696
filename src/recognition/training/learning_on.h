#pragma once

#include <vector>

#include "learning/binary_svms.h"
#include "learning/packed_gram.h"

namespace place_recognition {

/// Adds samples to one-against-all machines, which stay as they are elsewhere. A machine f becomes
/// f + sum_i beta_i K(x_i, .), which interpolates a change: 0 at the vectors of f, and at each
/// added sample what it lacks for its own place to lead by 1 (at +1 at most; other places give way
/// only if that does not suffice). An SVM that is trained anew on the vectors and the samples would
/// only keep the vectors' decision values beyond +1 or -1: samples of one place in another light
/// would attract the views of every place in that light.
///
/// `rows`: of `gram`, ascending; the first ones are the vectors of `machines`, the others the added
/// samples. `labels`: the place of each row. `ridge`: added to the kernel's diagonal. Returns
/// machines over `rows`.
BinarySvms learnOn(const BinarySvms& machines, const PackedGram& gram, const std::vector<int>& rows,
                   const std::vector<int>& labels, double ridge);

}  // namespace place_recognition
