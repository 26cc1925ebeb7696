#include "learning/column_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_recognition {
namespace {

/// At this fraction of the largest norm, the remainder of a column is rounding error.
double roundingError(Eigen::Index rows) {
  return static_cast<double>(rows) * std::numeric_limits<double>::epsilon();
}

/// The first candidate with the largest norm (eq. 6.18); after normalization all norms are equal up
/// to rounding. Updates as few columns as possible, because the remainder of a column can only have
/// decreased.
Eigen::Index findPivot(PivotedQr& qr) {
  const auto norms = qr.squaredNorms().head(qr.candidates());
  while (true) {
    const double equal = (1 - roundingError(qr.rows())) * norms.maxCoeff();
    Eigen::Index first = 0;
    while (norms[first] < equal) ++first;
    if (qr.isUpToDate(first)) return first;
    qr.update(first);
  }
}

void reportChoice(const Progress& progress, Eigen::Index chosen, Eigen::Index max_count) {
  report(progress, "Reducing", static_cast<double>(chosen) / static_cast<double>(max_count));
}

}  // namespace

Eigen::VectorXd chooseByPivot(PivotedQr& qr, const ChoiceLimits& limits, const Progress& progress) {
  const double least = std::max(limits.tau, roundingError(qr.rows()));
  std::vector<double> pivots;
  for (Eigen::Index count = 0; count < limits.max_count; ++count) {
    reportChoice(progress, count, limits.max_count);
    const Eigen::Index best = findPivot(qr);
    const double pivot = std::sqrt(qr.squaredNorms()[best]);
    if (!(pivot > 0) || (count > 0 && !(pivot > least * pivots.front()))) break;
    pivots.push_back(pivot);
    qr.choose(best);
  }
  qr.updateAll();
  Eigen::VectorXd relative = Eigen::Map<Eigen::VectorXd>(pivots.data(), pivots.size());
  if (relative.size() > 0) relative /= relative[0];
  return relative;
}

Eigen::VectorXd orthogonalMatchingPursuit(PivotedQr& qr, const ChoiceLimits& limits,
                                          const Progress& progress) {
  const Eigen::Index m = qr.candidates();
  const Eigen::Index targets = qr.squaredNorms().size() - m;
  const auto columnNorms = [&] { return qr.squaredNorms().head(m).array(); };
  const auto gap = [&] { return qr.squaredNorms().tail(targets).sum(); };

  const double first_gap = gap();
  const double least_gap = std::pow(limits.tau, 2) * first_gap;
  std::vector<double> left;
  const double least_norm = std::pow(roundingError(qr.rows()), 2) * columnNorms().maxCoeff();
  Eigen::MatrixXd products = qr.targetProducts();
  for (Eigen::Index count = 0; count < limits.max_count && (count == 0 || gap() > least_gap);
       ++count) {
    reportChoice(progress, count, limits.max_count);
    // The remainder of the targets decreases by the square of its component along each column.
    const Eigen::ArrayXd gains =
        (columnNorms() > least_norm)
            .select(products.rowwise().squaredNorm().array() / columnNorms(), 0);
    Eigen::Index best = 0;
    if (!(gains.maxCoeff(&best) > 0)) break;
    left.push_back(std::sqrt(gap() / first_gap));
    qr.choose(best);
    qr.updateAll();
    const auto row = qr.r().row(count);
    products.noalias() -= row.head(m).transpose() * row.tail(targets);
  }
  return Eigen::Map<Eigen::VectorXd>(left.data(), static_cast<Eigen::Index>(left.size()));
}

Eigen::Index rankAt(const Eigen::VectorXd& norms, double tau) {
  return std::max<Eigen::Index>((norms.array() > tau).count(),
                                std::min<Eigen::Index>(1, norms.size()));
}

}  // namespace place_recognition
