#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/run.h"

namespace place_recognition {

/// A model and what it took.
struct Training {
  Model model;
  std::uint64_t images = 0;                      ///< trained on
  std::vector<std::uint64_t> unreduced_vectors;  ///< [cue]: support vectors before reduction
  std::vector<std::string> warnings;  ///< for a person: skipped images and why, few images, ...
  double seconds = 0;
};

/// Opens a run when its turn has come.
using RunOpener = std::function<std::unique_ptr<Run>()>;

/// Learns a model from labelled runs: features of every frame (memory is bounded by them, not by
/// the runs), Gram matrix, gamma by cross-validation where it is not given, machines, reduction
/// (for `auto` chosen by cross-validation), calibration on held-out blocks of time. Throws Error if
/// fewer than two places have images; Cancelled if `progress` asks for it. The model's bytes depend
/// on inputs and options only, not on `threads` (0: one a core).
Training train(const std::vector<RunOpener>& runs, const TrainingOptions& options,
               unsigned threads = 0, const Progress& progress = {});

}  // namespace place_recognition
