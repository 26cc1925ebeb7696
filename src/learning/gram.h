#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/kernel.h"
#include "place_recognition/feature.h"
#include "place_recognition/progress.h"

namespace place_recognition {

class SupportSet;

/// The symmetric n x n matrix of kernel.measure() of n features of one kind. Uses `threads` threads
/// (0: one per core); the result is the same for any number.
Eigen::MatrixXd measureMatrix(const Kernel& kernel, const std::vector<Feature>& features,
                              unsigned threads, const Progress& progress);

/// Only the first `columns` columns of such a matrix.
Eigen::MatrixXd measureColumns(const Kernel& kernel, const std::vector<Feature>& features,
                               std::size_t columns, unsigned threads);

/// The Gram matrix (eq. 5.33): kernel.value() of every element.
Eigen::MatrixXd gramMatrix(const Kernel& kernel, const Eigen::MatrixXd& measures);

/// The kernel values of the `chosen` features (rows), none of which is missing, and the vectors of
/// a support set (columns). `threads`: 0 means one per core; changes no result.
Eigen::MatrixXd kernelValues(const std::vector<Feature>& features, const std::vector<int>& chosen,
                             const SupportSet& support_set, unsigned threads,
                             const Progress& progress = {});

}  // namespace place_recognition
