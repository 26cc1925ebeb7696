#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "datasets/image_set.h"
#include "experiments/test_sets.h"
#include "learning/binary_svms.h"
#include "place_recognition/progress.h"
#include "place_recognition/training_options.h"
#include "recognition/training/samples.h"

namespace place_recognition {

/// The features of chapter 8: local, SIFT at Harris-Laplace points and the local kernel (8.2), or
/// global, second derivatives at scales 1 and 4 with 28 bins and the chi-squared kernel (8.3).
enum class PlaceFeatures { kLocal, kGlobal };
const char* name(PlaceFeatures features);

/// Cue, size of images (512 pixels wide) and C = 100, which is what the thesis' cross-validation
/// found for every training set; gamma is open.
TrainingOptions trainingOptions(PlaceFeatures features);

/// A classifier trained on some samples, before any reduction, and what it is tested on.
struct PlaceTraining {
  double gamma = 0;  ///< found by cross-validation on blocks of the training samples
  BinarySvms machines;
  Eigen::MatrixXd training_values;  ///< kernel values: training images x support vectors
  Eigen::MatrixXd test_values;      ///< test images x support vectors
  std::vector<int> test;            ///< samples tested

  double rate(const BinarySvms& tested, const SetSamples& samples) const {
    return meanRate(testCounts(samples, test, answersOf(tested, test_values)));
  }
};

/// The images of all sets as features. Images without any are left out, as those of fewer than
/// five interest points are in the thesis.
class PlaceSamples {
 public:
  PlaceSamples(const std::vector<ImageSet>& sets, PlaceFeatures features, unsigned threads,
               const Progress& progress);

  PlaceTraining train(const Fold& split, const Progress& progress) const;

  /// Kernel::measure() of all samples (rows and columns).
  Eigen::MatrixXd measures(const Progress& progress) const;
  /// The Gram matrix of these measures.
  Eigen::MatrixXd gramMatrix(const Eigen::MatrixXd& measures, double gamma) const;

  const SetSamples& samples() const { return set_samples_; }
  const std::vector<std::string>& places() const { return samples_.places; }

 private:
  TrainingOptions options_;
  unsigned threads_;
  Samples samples_;
  SetSamples set_samples_;
};

}  // namespace place_recognition
