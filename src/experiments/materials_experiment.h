#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "datasets/picture_set.h"
#include "experiments/experiment.h"
#include "experiments/test_sets.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// A classifier of chapter 7, but for what it is trained on.
struct MaterialClassifier {
  std::string feature;  ///< mr8 or lbp
  KernelOptions kernel;
  SvmOptions svm;
};

/// The kernel's name and the parameters it has, as in "polynomial p=0 d=4".
std::string describe(const KernelOptions& kernel);

/// Chapter 7: support vector reduction on materials. Each sample of the materials is tested on in
/// turn, the others are trained on. One cell a classifier and tested sample, over two features,
/// chi-squared and Gaussian kernels of gamma 10^-3 ... 10^3, polynomial kernels of p = 0, 1 and d =
/// 1 ... 5, both ways of many classes, C = 100, and for Table 7.2 C = 1, 10 and 1000.
class MaterialsExperiment : public Experiment {
 public:
  /// `samples`: pictures of every material each; three or more. `threads`: 0: one per core.
  MaterialsExperiment(std::vector<PictureSet> samples, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  Json cellOf(const MaterialClassifier& classifier, const PictureSet& tested) const;
  Json evaluate(const MaterialClassifier& classifier, int tested, const SetSamples& samples,
                const Eigen::MatrixXd& measures) const;

  std::vector<PictureSet> sets_;
  unsigned threads_;
  std::vector<MaterialClassifier> classifiers_;
};

}  // namespace place_recognition
