#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/experiment.h"

namespace place_recognition {

/// Part `number` of `count` of an experiment's cells, 1..count.
struct Part {
  int number = 1;
  int count = 1;
};

/// What a run of an experiment came to.
struct ExperimentOutcome {
  std::size_t cells = 0;     ///< of the whole experiment
  std::size_t computed = 0;  ///< now; the other ones of this part were there
  std::size_t missing = 0;   ///< of the other parts
  std::string text;          ///< the tables, if nothing is missing
};

/// Computes the cells of `part` that `folder`/cells does not hold. Once all cells are there, writes
/// the tables (text, CSV), figures (SVG), pages (HTML) and results (JSON) to `folder`; their bytes
/// depend on data and experiment only. `data_digest`: of the images. Throws Error, Cancelled.
ExperimentOutcome runExperiment(Experiment& experiment, const std::string& folder,
                                const std::string& data_digest, const Part& part,
                                const Progress& progress);

}  // namespace place_recognition
