#include "learning/selection.h"

namespace place_recognition {

Eigen::MatrixXd pickRows(const Eigen::MatrixXd& matrix, const std::vector<int>& rows) {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), matrix.cols());
  for (Eigen::Index i = 0; i < part.rows(); ++i) {
    part.row(i) = matrix.row(rows[static_cast<std::size_t>(i)]);
  }
  return part;
}

Eigen::MatrixXd pickColumns(const Eigen::MatrixXd& matrix, const std::vector<int>& columns) {
  Eigen::MatrixXd part(matrix.rows(), static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index j = 0; j < part.cols(); ++j) {
    part.col(j) = matrix.col(columns[static_cast<std::size_t>(j)]);
  }
  return part;
}

Eigen::MatrixXd submatrix(const Eigen::MatrixXd& matrix, const std::vector<int>& rows,
                          const std::vector<int>& columns) {
  Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()),
                       static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index j = 0; j < part.cols(); ++j) {
    const auto column = matrix.col(columns[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < part.rows(); ++i) {
      part(i, j) = column[rows[static_cast<std::size_t>(i)]];
    }
  }
  return part;
}

}  // namespace place_recognition
