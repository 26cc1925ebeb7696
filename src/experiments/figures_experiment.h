#pragma once

#include <vector>

#include "experiments/experiment.h"

namespace place_recognition {

/// Figures 5.5, 6.1 and 6.2, and one of kernels: machines on artificial points of the plane. One
/// cell per panel.
class FiguresExperiment : public Experiment {
 public:
  std::vector<Json> cells() const override;
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& progress) override;
  Findings findings(const std::vector<Json>& results) const override;
};

}  // namespace place_recognition
