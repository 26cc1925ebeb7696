#pragma once

#include "learning/pivoted_qr.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// When to stop choosing columns.
struct ChoiceLimits {
  double tau;              ///< see the functions
  Eigen::Index max_count;  ///< columns chosen at most
};

/// QR with column pivoting: always the column of which most is left (eq. 6.18), while that is more
/// than `tau` of the first. Returns these norms relative to the first, in descending order.
Eigen::VectorXd chooseByPivot(PivotedQr& qr, const ChoiceLimits& limits, const Progress& progress);

/// Orthogonal matching pursuit with several targets: always the column that explains most of what
/// is left of all right-hand sides together, while that is more than `tau` of their norm. Returns
/// what was left before each choice relative to that norm, in descending order.
Eigen::VectorXd orthogonalMatchingPursuit(PivotedQr& qr, const ChoiceLimits& limits,
                                          const Progress& progress);

/// How many of the columns whose `norms` one of these functions returned are kept for `tau`: all
/// of more than it, and always the first.
Eigen::Index rankAt(const Eigen::VectorXd& norms, double tau);

}  // namespace place_recognition
