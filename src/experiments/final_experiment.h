#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/place_training.h"

namespace place_recognition {

/// Tables 8.2 and 8.6, and the splits of Table 8.1. One cell per training set.
class FinalExperiment : public Experiment {
 public:
  /// Trains on each of `sets` in turn. `threads`: 0 means one per core.
  FinalExperiment(PlaceFeatures features, std::vector<ImageSet> sets, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  Table splits() const;

  PlaceFeatures features_;
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace place_recognition
