#pragma once

#include <string>
#include <vector>

#include "datasets/image_set.h"
#include "experiments/experiment.h"
#include "experiments/material_grid.h"
#include "experiments/test_sets.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// Chapter 7: support vector reduction on materials. Some samples of each material are trained on,
/// and the others are tested on. One cell per feature, split and kernel, for all machines with that
/// kernel; see material_grid.h.
class MaterialsExperiment : public Experiment {
 public:
  /// `samples`: at least three, each with images of every material. `threads`: 0 means one per
  /// core.
  MaterialsExperiment(std::vector<ImageSet> samples, unsigned threads);

  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;

 private:
  Json cellOf(const std::string& feature, const TrainingSamples& split,
              const KernelOptions& kernel) const;
  /// `cells`: one per kernel; null if it is not requested.
  void computeSplit(const TrainingSamples& split, const std::vector<const Json*>& cells,
                    const SetSamples& samples, const std::vector<Feature>& features,
                    const CellSink& finished, const Progress& progress) const;

  std::vector<ImageSet> sets_;
  unsigned threads_;
  std::vector<TrainingSamples> splits_;
};

}  // namespace place_recognition
