#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition {

/// Quality of the answers to frames of known places.
struct AnswerFigures {
  double average_rate = 0;       ///< 0..1, mean of the places' rates
  double calibration_error = 0;  ///< expected calibration error, 0..1
  double unknown = 0;            ///< fraction of frames answered 'unknown'
};

/// A recalibrated model, and its answers to the calibration set before and after.
struct Recalibration {
  Model model;
  AnswerFigures before;
  AnswerFigures after;  ///< each block of a room is judged by a calibration fitted on the others
  std::uint64_t images = 0;
  std::vector<std::string> warnings;  ///< for a person: skipped images
};

/// Fits the weights of the cues, the slope of the probabilities, the weights of evidence and the
/// threshold of 'unknown' anew to labelled `recordings` that the model was not trained on; its
/// machines stay the same. The threshold leaves the configured fraction of these frames 'unknown'
/// as a recognizer sees them, in the order of each recording. Frames of places unknown to the model
/// are skipped. Later incremental training validates on these frames. Throws Error if fewer
/// than 5 frames are left; Cancelled if `progress` requests it.
Recalibration recalibrate(Model model, const std::vector<RecordingOpener>& recordings,
                          unsigned threads = 0, const Progress& progress = {});

}  // namespace place_recognition
