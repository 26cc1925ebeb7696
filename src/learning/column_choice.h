#pragma once

#include "learning/column_elimination.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// When to stop choosing columns.
struct ChoiceLimits {
  double tau;              ///< see the functions
  Eigen::Index max_count;  ///< columns chosen at most
};

/// QR with column pivoting: always the column of which most is left (eq. 6.18), while that is more
/// than `tau` of the first. Returns these norms relative to the first, in descending order.
Eigen::VectorXd chooseByPivot(ColumnElimination& elimination, const ChoiceLimits& limits,
                              const Progress& progress);

/// Orthogonal matching pursuit with several targets: always the column that explains most of what
/// is left of all right-hand sides together, while that is more than `tau` of their norm.
void chooseByFit(ColumnElimination& elimination, const ChoiceLimits& limits,
                 const Progress& progress);

}  // namespace place_recognition
