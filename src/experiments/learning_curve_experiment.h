#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"

namespace place_recognition {

/// Measures how much training data is needed and which viewpoints matter (section 9.1): the rate on
/// the other sets, with global features, for 1, 2, 4 ... images per room, either spread over its
/// viewpoints or from neighbouring ones, and without each viewpoint in turn. A viewpoint is twelve
/// successive images of a room, one marker of KTH-INDECS. One cell per training set; gamma is found
/// on the whole training set.
class LearningCurveExperiment : public Experiment {
 public:
  /// Trains on each of `sets` in turn. `threads`: 0 means one per core.
  LearningCurveExperiment(std::vector<ImageSet> sets, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace place_recognition
