#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/place_training.h"

namespace place_recognition {

/// Whether what was learned carries to new places of the same kind (section 9.1): all buildings but
/// one are trained on, that one is tested on. One cell a kind of features and tested building.
class CategoriesExperiment : public Experiment {
 public:
  /// `buildings`: three or more, whose places of one kind have one name. `threads`: 0: one per
  /// core. Throws Error if there are fewer.
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
