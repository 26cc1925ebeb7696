#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/place_training.h"

namespace place_recognition {

/// Tables 8.3 and 8.7: support vector reduction of the classifiers of Tables 8.2 and 8.6 by the
/// thesis' method, with and without normalization, and by the two methods with one basis for all
/// machines. One cell per kind of features, training set, method and normalization.
class ReductionExperiment : public Experiment {
 public:
  /// Trains on each of `sets` in turn. `threads`: 0 means one per core.
  ReductionExperiment(std::vector<ImageSet> sets, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace place_recognition
