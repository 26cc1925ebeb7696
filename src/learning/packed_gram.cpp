#include "learning/packed_gram.h"

#include <svm.h>

#include <algorithm>
#include <cstddef>

#include "base/parallel.h"

namespace place_recognition {
namespace {

/// Number of rows and columns of the source read at a time. The source is column-major and the
/// target row-major, and both parts must fit into the first-level cache.
constexpr Eigen::Index kTile = 32;

static_assert(sizeof(svm_node) == 2 * sizeof(double) && offsetof(svm_node, value) == sizeof(double),
              "two rows can share memory only if half of a node is its value");

}  // namespace

PackedGram::PackedGram(const Kernel& kernel, const Eigen::MatrixXd& measures, unsigned threads)
    : rows_(measures.rows()), columns_(measures.cols()) {
  fill(measures, threads, [&kernel](double measure) { return kernel.value(measure); });
}

PackedGram::PackedGram(const Eigen::MatrixXd& values)
    : rows_(values.rows()), columns_(values.cols()) {
  fill(values, 1, [](double value) { return value; });
}

template <typename Value>
void PackedGram::fill(const Eigen::MatrixXd& source, unsigned threads, Value value) {
  memory_.reset(new double[static_cast<std::size_t>((rows_ + 1) / 2 * pairSize())]);
  const auto tile_rows = static_cast<std::size_t>((rows_ + kTile - 1) / kTile);
  parallelFor(tile_rows, threads, [&](std::size_t tile, unsigned) {
    const Eigen::Index begin = static_cast<Eigen::Index>(tile) * kTile;
    const Eigen::Index end = std::min(rows_, begin + kTile);
    for (Eigen::Index i = begin; i < end; ++i) rowStart(i)[1] = static_cast<double>(i + 1);
    for (Eigen::Index first = 0; first < columns_; first += kTile) {
      for (Eigen::Index i = begin; i < end; ++i) {
        double* row = rowStart(i) + 3;
        for (Eigen::Index j = first; j < std::min(columns_, first + kTile); ++j) {
          row[2 * j] = value(source(i, j));
        }
      }
    }
  });
}

Eigen::MatrixXd PackedGram::values(const std::vector<int>& rows,
                                   const std::vector<int>& columns) const {
  Eigen::MatrixXd part(rows.size(), columns.size());
  for (Eigen::Index i = 0; i < part.rows(); ++i) {
    const double* row = rowStart(rows[static_cast<std::size_t>(i)]) + 3;
    for (Eigen::Index j = 0; j < part.cols(); ++j) {
      part(i, j) = row[2 * columns[static_cast<std::size_t>(j)]];
    }
  }
  return part;
}

svm_node* PackedGram::nodes(Eigen::Index row) const {
  return reinterpret_cast<svm_node*>(rowStart(row));
}

}  // namespace place_recognition
