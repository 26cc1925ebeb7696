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

/// Cue, image width (512 pixels) and C = 100, which the thesis' cross-validation found for every
/// training set; gamma is not fixed.
TrainingOptions trainingOptions(PlaceFeatures features);

/// A classifier trained on some samples, before reduction, and its test data.
struct PlaceTraining {
  double gamma = 0;  ///< found by cross-validation on blocks of the training samples
  BinarySvms machines;
  Eigen::MatrixXd training_values;  ///< kernel values: training images x support vectors
  Eigen::MatrixXd test_values;      ///< test images x support vectors
  std::vector<int> test;            ///< test samples

  double rate(const BinarySvms& tested, const SetSamples& samples) const {
    return meanRate(testCounts(samples, test, answersOf(tested, test_values)));
  }
};

/// The features of the images of all sets. Images without a feature are omitted, as images with
/// fewer than five interest points are in the thesis.
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
  /// Which images are omitted and why.
  const std::vector<std::string>& warnings() const { return samples_.warnings; }

 private:
  TrainingOptions options_;
  unsigned threads_;
  Samples samples_;
  SetSamples set_samples_;
};

}  // namespace place_recognition
