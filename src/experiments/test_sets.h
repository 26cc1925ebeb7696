#pragma once

#include <Eigen/Core>
#include <vector>

#include "datasets/image_set.h"
#include "learning/binary_svms.h"
#include "learning/folds.h"

namespace place_recognition {

/// Samples of several sets, one of which is trained on at a time. Each room of each other set is
/// one test set; all test sets have equal weight (thesis section 8.1).
struct SetSamples {
  std::vector<int> places;  ///< of each sample
  std::vector<int> sets;    ///< of each sample
  int place_count = 0;
  int set_count = 0;

  /// Trains on `set`, tests on all others.
  Fold split(int set) const;
};

/// The images of all sets, one set after another; places are numbered in order of their names.
SetSamples samplesOf(const std::vector<ImageSet>& sets);

/// Number of images of one test set, and of correct answers.
struct TestCount {
  int place = 0;
  int set = 0;
  int right = 0;
  int total = 0;
};

/// Counts by test set, in order of place, then set; sets without images are omitted. `answers`: one
/// place for each of `test`.
std::vector<TestCount> testCounts(const SetSamples& samples, const std::vector<int>& test,
                                  const std::vector<int>& answers);

/// Mean of the test sets' rates, 0..1; 0 if there are none.
double meanRate(const std::vector<TestCount>& counts);

/// The place with the largest decision value for each row of `kernel_values`.
std::vector<int> answersOf(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values);

/// meanRate() on `fold.test` of machines trained on `fold.train`; `gram`: of all samples.
double rateOf(const Eigen::MatrixXd& gram, const SetSamples& samples, const Fold& fold,
              const SvmOptions& svm);

}  // namespace place_recognition
