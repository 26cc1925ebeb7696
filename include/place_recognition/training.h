#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/recording.h"

namespace place_recognition {

/// A model and the figures of its training.
struct Training {
  Model model;
  std::uint64_t images = 0;                      ///< trained on
  std::uint64_t passed_over = 0;                 ///< not drawn although usable, see SamplingOptions
  std::vector<std::uint64_t> unreduced_vectors;  ///< [cue]: support vectors before reduction
  std::vector<std::string> warnings;  ///< for a person: skipped images, too few images, ...
  double seconds = 0;
};

/// Opens a recording when it is needed.
using RecordingOpener = std::function<std::unique_ptr<Recording>()>;

/// Called when all recordings have been read, before anything is learned, with the sketches of all
/// runs that the model learns or has learned, and the levels by which they were read. An exception
/// ends the training.
using AfterReading =
    std::function<void(const std::vector<RunSketch>& learned, const LevelRange& levels)>;

/// Trains a model from labelled recordings: features of every frame (memory is bounded by them, not
/// by the length of the runs), Gram matrix, gamma by cross-validation if it is not given, machines,
/// reduction (for `auto` selected by cross-validation), calibration on held-out blocks of time. An
/// image that an earlier recording has shown counts once.
/// Throws Error if fewer than two places have images; Cancelled if `progress` requests it. The
/// model's bytes depend on inputs and options only, not on `threads` (0: one per core).
Training train(const std::vector<RecordingOpener>& recordings, const TrainingOptions& options,
               unsigned threads = 0, const Progress& progress = {},
               const AfterReading& after_reading = {});

/// Options of incremental training.
struct IncrementalOptions {
  /// Maximum number of support vectors per cue. The threshold of shared-greedy reduction is adapted
  /// to it, so the vectors with the least effect on all decision values together are forgotten. 0:
  /// no limit, or the requested reduction if it sets a number or a tau.
  int vector_limit = 0;
  /// Within that limit, how much less the decision values at a vector count each time its place is
  /// learned again, 0..1. 0: only a vector's effect decides whether it is forgotten, not its age.
  double forgetting = 0;
  /// Model of another robot whose support vectors are also learned.
  const Model* other = nullptr;
};

/// Incremental training (thesis section 9.1): trains on the support vectors of `model` and on the
/// labelled frames of new `recordings`, which may show known or new places (there may be none if
/// there is another model). Features, kernels and gammas stay those of the model. Without
/// a limit and another model, one-against-all machines are extended by those of new places. Without
/// another model, the weights of the cues and what is "unknown" in known places stay. Otherwise,
/// the held-out frames of the new runs and those on which the models were validated determine the
/// weights of the cues and the calibration. Fewer images than SamplingOptions::most are learned if
/// the models have many support vectors, but at least 1000. Throws like train(), but one new place
/// is enough; also if the models were trained with different features.
Training trainIncrementally(const Model& model, const std::vector<RecordingOpener>& recordings,
                            const IncrementalOptions& incremental, unsigned threads = 0,
                            const Progress& progress = {}, const AfterReading& after_reading = {});

}  // namespace place_recognition
