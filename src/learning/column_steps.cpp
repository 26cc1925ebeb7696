#include "learning/column_steps.h"

#include <algorithm>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// Sums are kept in so many parts, so that the order of adding is the same whatever the registers.
constexpr int kLanes = 8;

PLACE_RECOGNITION_INLINE double addLanes(const double* x) {
  return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

/// kSteps steps done to kColumns columns: the products of all are found in one pass, and what a
/// step would have taken out before the next is made up for by their overlap (Bjorck 1994).
template <int kSteps, int kColumns>
PLACE_RECOGNITION_INLINE void takeOutTile(const ColumnSteps& steps, double* const* columns,
                                          double* const* products, Eigen::Index n) {
  const double* q[kSteps];
  for (int s = 0; s < kSteps; ++s) q[s] = steps.q[s];
  double* a[kColumns];
  for (int c = 0; c < kColumns; ++c) a[c] = columns[c];

  double sums[kSteps][kColumns][kLanes] = {};
  for (Eigen::Index i = 0; i < n; i += kLanes) {
    for (int s = 0; s < kSteps; ++s) {
      for (int c = 0; c < kColumns; ++c) {
        PLACE_RECOGNITION_LANES
        for (int k = 0; k < kLanes; ++k) sums[s][c][k] += q[s][i + k] * a[c][i + k];
      }
    }
  }
  double p[kSteps][kColumns];
  for (int s = 0; s < kSteps; ++s) {
    for (int c = 0; c < kColumns; ++c) {
      p[s][c] = addLanes(sums[s][c]);
      for (int t = 0; t < s; ++t) p[s][c] -= steps.overlaps[s][t] * p[t][c];
      products[c][s] = p[s][c];
    }
  }
  PLACE_RECOGNITION_INDEPENDENT
  for (Eigen::Index i = 0; i < n; ++i) {
    double taken[kSteps];
#pragma GCC unroll 4
    for (int s = 0; s < kSteps; ++s) taken[s] = q[s][i];
#pragma GCC unroll 4
    for (int c = 0; c < kColumns; ++c) {
      double left = a[c][i];
#pragma GCC unroll 4
      for (int s = 0; s < kSteps; ++s) left -= p[s][c] * taken[s];
      a[c][i] = left;
    }
  }
}

template <int kColumns>
PLACE_RECOGNITION_INLINE void takeOutOf(double* const* columns, double* const* products,
                                        const ColumnSteps& steps, Eigen::Index n) {
  switch (steps.count) {
    case 1:
      return takeOutTile<1, kColumns>(steps, columns, products, n);
    case 2:
      return takeOutTile<2, kColumns>(steps, columns, products, n);
    case 3:
      return takeOutTile<3, kColumns>(steps, columns, products, n);
    default:
      return takeOutTile<4, kColumns>(steps, columns, products, n);
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void takeOutOf(int columns, const ColumnSteps& steps, double* const* values,
               double* const* products, Eigen::Index n) {
  switch (columns) {
    case 1:
      return takeOutOf<1>(values, products, steps, n);
    case 2:
      return takeOutOf<2>(values, products, steps, n);
    case 3:
      return takeOutOf<3>(values, products, steps, n);
    default:
      return takeOutOf<4>(values, products, steps, n);
  }
}

/// How many columns fit the registers with the sums of four steps.
int columnsAtOnce() {
#if defined(__x86_64__) && defined(__GNUC__)
  return __builtin_cpu_supports("avx512f") ? 4 : 2;
#else
  return 2;
#endif
}

}  // namespace

void takeOut(const ColumnSteps& steps, const ColumnTeam& team, Eigen::Index n) {
  static const int at_once = columnsAtOnce();
  for (int c = 0; c < team.count; c += at_once) {
    takeOutOf(std::min(at_once, team.count - c), steps, team.values + c, team.products + c, n);
  }
}

PLACE_RECOGNITION_TARGET_CLONES
double innerProduct(const double* x, const double* y, Eigen::Index n) {
  double sums[2 * kLanes] = {};
  for (Eigen::Index i = 0; i < n; i += 2 * kLanes) {
    for (int k = 0; k < 2 * kLanes; ++k) sums[k] += x[i + k] * y[i + k];
  }
  for (int k = 0; k < kLanes; ++k) sums[k] += sums[k + kLanes];
  return addLanes(sums);
}

}  // namespace place_recognition
