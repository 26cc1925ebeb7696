#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// Some consecutive steps of modified Gram-Schmidt.
struct ColumnSteps {
  static constexpr int kMost = 4;

  int count;               ///< 1 to kMost
  const double* q[kMost];  ///< the column of Q that each takes out
  /// (s, t) with t < s: q[s]'q[t], which rounding keeps from being zero.
  double overlaps[kMost][kMost];
};

/// Columns that the same steps are done to, and where the parts that are taken out are written.
struct ColumnTeam {
  static constexpr int kMost = 4;

  int count = 0;
  double* values[kMost];
  double* products[kMost];  ///< a number for each step
};

/// Number for number what the steps, one after the other, do to each column by itself; but what
/// they need of the memory is visited less often. Columns have `n` numbers, a multiple of 16. Same
/// bits on every machine.
void takeOut(const ColumnSteps& steps, const ColumnTeam& team, Eigen::Index n);

/// x'y, in an order that is the same for every instruction set. `n` as above.
double innerProduct(const double* x, const double* y, Eigen::Index n);

}  // namespace place_recognition
