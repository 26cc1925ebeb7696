#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"

namespace place_recognition {

/// How much training data is needed, and which viewpoints count (section 9.1): the rate on the
/// other sets, with global features, of 1, 2, 4 ... images per room, spread over its viewpoints or
/// all from neighbouring ones, and without each viewpoint in turn. A viewpoint is twelve successive
/// images of a room, a marker of KTH-INDECS. One cell a training set; gamma is that found on the
/// whole of it.
class LearningCurveExperiment : public Experiment {
 public:
  /// Each of `sets` is trained on in turn. `threads`: 0: one per core.
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
