#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/machines.h"
#include "place_recognition/learning_options.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// Support vector reduction, thesis chapter 6: fewer vectors, nearly the same margins.
/// `kernel_values` is the n x m matrix K of eq. 6.19, K(y_i, x_j) of n training vectors and the m
/// vectors of `machines`. Returns machines over the same m vectors in which fewer rows of weights
/// are not zero (never more than before).
///
/// qr            each machine on its own support vectors; weights by eq. 6.21
/// shared-qr     pivoted QR of all columns once, one basis for all machines, weights refitted
/// shared-greedy basis grown one vector at a time so that all machines' margins on the training
///               vectors are reproduced best (orthogonal matching pursuit), weights refitted
/// none          the machines as they are
Machines reduce(const Machines& machines, const Eigen::MatrixXd& kernel_values,
                const ReductionOptions& options, const Progress& progress = {});

}  // namespace place_recognition
