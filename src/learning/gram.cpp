#include "learning/gram.h"

#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "learning/support_set.h"

namespace place_recognition {
namespace {

/// Number of features compared at a time: few enough for their sums to stay in the cache, and
/// enough for the lookup of bins to be a small part of the work.
constexpr std::size_t kBlock = 1024;

/// Counts finished rows from any thread and reports every per cent, starting with the first row.
class RowProgress {
 public:
  RowProgress(const Progress& progress, std::size_t rows) : progress_(progress), rows_(rows) {}

  void finishRow(unsigned thread) {
    const double fraction = static_cast<double>(++done_) / static_cast<double>(rows_);
    if (thread != 0 || fraction < reported_ + 0.01) return;
    reported_ = fraction;
    report(progress_, "Comparing images", fraction);
  }

 private:
  const Progress& progress_;
  const std::size_t rows_;
  std::atomic<std::size_t> done_{0};
  double reported_ = 0;
};

SupportSet blockOf(const Kernel& kernel, const std::vector<Feature>& features, std::size_t begin,
                   std::size_t end) {
  if (begin == 0 && end == features.size()) return SupportSet(kernel, features);
  return SupportSet(kernel, {features.data() + begin, features.data() + end});
}

/// Number of rows and columns of all blocks, that is, of comparisons of a feature with a block.
std::size_t rowCount(std::size_t n) {
  std::size_t rows = 0;
  for (std::size_t begin = 0; begin < n; begin += kBlock) rows += n - begin;
  return rows;
}

}  // namespace

Eigen::MatrixXd measureMatrix(const Kernel& kernel, const std::vector<Feature>& features,
                              unsigned threads, const Progress& progress) {
  const std::size_t n = features.size();
  Eigen::MatrixXd measures(n, n);
  RowProgress row_progress(progress, rowCount(n));
  for (std::size_t begin = 0; begin < n; begin += kBlock) {
    const std::size_t end = std::min(n, begin + kBlock);
    const SupportSet block = blockOf(kernel, features, begin, end);
    // Column i is computed down to the diagonal and mirrored, so that the matrix is exactly
    // symmetric.
    parallelFor(n - begin, threads, [&](std::size_t offset, unsigned thread) {
      const std::size_t count = std::min(offset + 1, block.size());
      block.measures(features[begin + offset], measures.col(begin + offset).segment(begin, count));
      row_progress.finishRow(thread);
    });
  }
  measures.triangularView<Eigen::StrictlyLower>() = measures.transpose();
  return measures;
}

Eigen::MatrixXd measureColumns(const Kernel& kernel, const std::vector<Feature>& features,
                               std::size_t columns, unsigned threads) {
  Eigen::MatrixXd measures(features.size(), columns);
  for (std::size_t begin = 0; begin < columns; begin += kBlock) {
    const std::size_t count = std::min(kBlock, columns - begin);
    const SupportSet block = blockOf(kernel, features, begin, begin + count);
    parallelFor(features.size(), threads, [&](std::size_t i, unsigned) {
      Eigen::VectorXd row(block.size());
      block.measures(features[i], row);
      measures.row(i).segment(begin, count) = row;
    });
  }
  return measures;
}

Eigen::MatrixXd gramMatrix(const Kernel& kernel, const Eigen::MatrixXd& measures) {
  return measures.unaryExpr([&](double measure) { return kernel.value(measure); });
}

Eigen::MatrixXd kernelValues(const std::vector<Feature>& features, const std::vector<int>& chosen,
                             const SupportSet& support_set, unsigned threads,
                             const Progress& progress) {
  Eigen::MatrixXd transposed(support_set.size(), chosen.size());
  constexpr std::size_t kReportPeriod = 64;  // features
  for (std::size_t begin = 0; begin < chosen.size(); begin += kReportPeriod) {
    report(progress, "Comparing vectors", static_cast<double>(begin) / chosen.size());
    const std::size_t count = std::min(kReportPeriod, chosen.size() - begin);
    parallelFor(count, threads, [&](std::size_t i, unsigned) {
      const auto feature = static_cast<std::size_t>(chosen[begin + i]);
      support_set.kernelValues(features[feature],
                               transposed.col(static_cast<Eigen::Index>(begin + i)));
    });
  }
  return transposed.transpose();
}

}  // namespace place_recognition
