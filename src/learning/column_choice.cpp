#include "learning/column_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_recognition {
namespace {

/// What is left of a column is rounding error at this share of the largest norm.
double roundingError(Eigen::Index rows) {
  return static_cast<double>(rows) * std::numeric_limits<double>::epsilon();
}

/// The first candidate of the largest norm (eq. 6.18); after normalization all are equal but for
/// rounding. Settles as few as it can: what is left of a column can only have become less.
Eigen::Index findPivot(PivotedQr& elimination) {
  const auto norms = elimination.squaredNorms().head(elimination.candidates());
  while (true) {
    const double equal = (1 - roundingError(elimination.rows())) * norms.maxCoeff();
    Eigen::Index first = 0;
    while (norms[first] < equal) ++first;
    if (elimination.isUpToDate(first)) return first;
    elimination.update(first);
  }
}

/// After so many choices all columns are settled: few, so that teams stay full.
constexpr Eigen::Index kChoicesOfTeams = 16;

void reportChoice(const Progress& progress, Eigen::Index chosen, Eigen::Index max_count) {
  report(progress, "Reducing", static_cast<double>(chosen) / static_cast<double>(max_count));
}

}  // namespace

Eigen::VectorXd chooseByPivot(PivotedQr& elimination, const ChoiceLimits& limits,
                              const Progress& progress) {
  const double least = std::max(limits.tau, roundingError(elimination.rows()));
  std::vector<double> pivots;
  for (Eigen::Index count = 0; count < limits.max_count; ++count) {
    reportChoice(progress, count, limits.max_count);
    if (count % kChoicesOfTeams == 0) elimination.updateAll();
    const Eigen::Index best = findPivot(elimination);
    const double pivot = std::sqrt(elimination.squaredNorms()[best]);
    if (!(pivot > 0) || (count > 0 && !(pivot > least * pivots.front()))) break;
    pivots.push_back(pivot);
    elimination.choose(best);
  }
  elimination.updateAll();
  Eigen::VectorXd relative = Eigen::Map<Eigen::VectorXd>(pivots.data(), pivots.size());
  if (relative.size() > 0) relative /= relative[0];
  return relative;
}

void orthogonalMatchingPursuit(PivotedQr& elimination, const ChoiceLimits& limits,
                               const Progress& progress) {
  const Eigen::Index m = elimination.candidates();
  const Eigen::Index targets = elimination.squaredNorms().size() - m;
  const auto columnNorms = [&] { return elimination.squaredNorms().head(m).array(); };
  const auto gap = [&] { return elimination.squaredNorms().tail(targets).sum(); };

  const double least_gap = std::pow(limits.tau, 2) * gap();
  const double least_norm =
      std::pow(roundingError(elimination.rows()), 2) * columnNorms().maxCoeff();
  Eigen::MatrixXd products = elimination.targetProducts();
  for (Eigen::Index count = 0; count < limits.max_count && gap() > least_gap; ++count) {
    reportChoice(progress, count, limits.max_count);
    // What is left of the targets shrinks by the square of its part along each column.
    const Eigen::ArrayXd gains =
        (columnNorms() > least_norm)
            .select(products.rowwise().squaredNorm().array() / columnNorms(), 0);
    Eigen::Index best = 0;
    if (!(gains.maxCoeff(&best) > 0)) break;
    elimination.choose(best);
    elimination.updateAll();
    const auto row = elimination.r().row(count);
    products.noalias() -= row.head(m).transpose() * row.tail(targets);
  }
}

}  // namespace place_recognition
