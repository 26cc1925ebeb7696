#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/kernel.h"
#include "place_recognition/feature.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// The symmetric n x n matrix of kernel.measure() of n features of one kind. Uses `threads` threads
/// (0: one per core); the result is the same for any number.
Eigen::MatrixXd measureMatrix(const Kernel& kernel, const std::vector<Feature>& features,
                              unsigned threads, const Progress& progress);

/// Only the first `columns` columns of such a matrix.
Eigen::MatrixXd measureColumns(const Kernel& kernel, const std::vector<Feature>& features,
                               std::size_t columns, unsigned threads);

/// The Gram matrix (eq. 5.33): kernel.value() of every element.
Eigen::MatrixXd gramMatrix(const Kernel& kernel, const Eigen::MatrixXd& measures);

}  // namespace place_recognition
