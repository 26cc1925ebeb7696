#pragma once

#include <Eigen/Core>
#include <vector>

namespace place_recognition {

/// The elements of `list` at `indices`.
template <typename T>
std::vector<T> pick(const std::vector<T>& list, const std::vector<int>& indices) {
  std::vector<T> picked;
  picked.reserve(indices.size());
  for (const int i : indices) picked.push_back(list[static_cast<std::size_t>(i)]);
  return picked;
}

/// The elements of `matrix` in the given rows, columns, or both.
Eigen::MatrixXd pickRows(const Eigen::MatrixXd& matrix, const std::vector<int>& rows);
Eigen::MatrixXd pickColumns(const Eigen::MatrixXd& matrix, const std::vector<int>& columns);
Eigen::MatrixXd submatrix(const Eigen::MatrixXd& matrix, const std::vector<int>& rows,
                          const std::vector<int>& columns);

}  // namespace place_recognition
