#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/experiment.h"
#include "place_recognition/part.h"

namespace place_recognition {

/// The outcome of a run of an experiment.
struct ExperimentOutcome {
  std::size_t cells = 0;     ///< of the whole experiment
  std::size_t computed = 0;  ///< in this run; the others of this part already existed
  std::size_t missing = 0;   ///< in other parts
  std::string text;          ///< the tables, if nothing is missing
};

/// Computes the cells of `part` that are missing in `folder`/cells. Once all cells exist, writes
/// the tables (text, CSV), figures (SVG), pages (HTML) and results (JSON) to `folder`; their bytes
/// depend on data and experiment only. `data_digest`: of the images. Throws Error, Cancelled.
ExperimentOutcome runExperiment(Experiment& experiment, const std::string& folder,
                                const std::string& data_digest, const Part& part,
                                const Progress& progress);

}  // namespace place_recognition
