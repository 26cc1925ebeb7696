#pragma once

#include "learning/pivoted_qr.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// Limits for the choice of columns.
struct ChoiceLimits {
  double tau;              ///< see the functions
  Eigen::Index max_count;  ///< maximum number of columns
};

/// QR with column pivoting: chooses the column with the largest remaining norm (eq. 6.18), as long
/// as that exceeds `tau` times the first. Returns these norms relative to the first, in descending
/// order.
Eigen::VectorXd chooseByPivot(PivotedQr& qr, const ChoiceLimits& limits, const Progress& progress);

/// Orthogonal matching pursuit with several targets: chooses the column that explains most of the
/// residual of all right-hand sides together, as long as the residual exceeds `tau` times their
/// norm. Returns the residual norm before each choice relative to that norm, in descending order.
Eigen::VectorXd orthogonalMatchingPursuit(PivotedQr& qr, const ChoiceLimits& limits,
                                          const Progress& progress);

/// How many of the columns, whose `norms` one of these functions returned, are kept for `tau`:
/// those with larger norms, and always the first.
Eigen::Index rankAt(const Eigen::VectorXd& norms, double tau);

}  // namespace place_recognition
