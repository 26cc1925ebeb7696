#pragma once

#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "place_recognition/training_options.h"

namespace place_recognition {

/// Compares two ways of combining cues (section 9.1): the weighted mean of their decision values,
/// which models use, and an SVM over the decision values of all cues (Pronobis, Martinez Mozos and
/// Caputo 2008). Both are fitted on the same held-out frames of the training set and tested on
/// single images of the other sets. One cell per set of cues and training set.
class CuesExperiment : public Experiment {
 public:
  /// Trains on each of `sets` in turn. `threads`: 0 means one per core.
  CuesExperiment(std::vector<ImageSet> sets, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  std::vector<ImageSet> sets_;
  unsigned threads_;
};

}  // namespace place_recognition
