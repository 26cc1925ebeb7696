#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/place_training.h"

namespace place_recognition {

/// Tests whether a classifier generalizes to new places of the same kind (section 9.1): it is
/// trained on all buildings but one and tested on that one. One cell per kind of features and
/// tested building.
class CategoriesExperiment : public Experiment {
 public:
  /// `buildings`: at least three, whose places of one kind share one name; throws Error if there
  /// are fewer. `threads`: 0 means one per core.
  CategoriesExperiment(std::vector<ImageSet> buildings, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  std::vector<ImageSet> buildings_;
  unsigned threads_;
};

}  // namespace place_recognition
