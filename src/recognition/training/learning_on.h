#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/binary_svms.h"
#include "learning/packed_gram.h"

namespace place_recognition {

/// The smallest changes, by the sum of their squares, after which each row of decision values leads
/// for its own place by its lead: the own place rises by as much as the others fall together. Zero
/// for rows that lead already. `labels`: the place of each row.
Eigen::MatrixXd changesToLead(const Eigen::MatrixXd& decision_values,
                              const std::vector<int>& labels, const std::vector<double>& leads);

/// Adds samples to one-against-all machines, which stay as they are elsewhere. A machine f becomes
/// f + sum_i beta_i K(x_i, .), which interpolates a change: 0 at the vectors of f, and a given one
/// at each added sample. An SVM that is trained anew on the vectors and the samples would only keep
/// the vectors' decision values beyond +1 or -1: samples of one place in another light would
/// attract the views of every place in that light.
///
/// `rows`: of `gram`, ascending; the first ones are the vectors of `machines`, the others the added
/// samples. `changes`: of the decision values of the added samples; samples with a change of zero
/// are not used. `ridge`: added to the kernel's diagonal. Returns machines over `rows`.
BinarySvms learnOn(const BinarySvms& machines, const PackedGram& gram, const std::vector<int>& rows,
                   const Eigen::MatrixXd& changes, double ridge);

}  // namespace place_recognition
