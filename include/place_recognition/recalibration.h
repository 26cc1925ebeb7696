#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition {

/// How frames of known places are answered.
struct AnswerFigures {
  double average_rate = 0;       ///< 0..1, mean of the places' rates
  double calibration_error = 0;  ///< expected calibration error, 0..1
  double unknown = 0;            ///< fraction of frames that are answered 'unknown'
};

/// A model with another calibration, and how it answers the runs of that.
struct Recalibration {
  Model model;
  AnswerFigures before;
  AnswerFigures after;  ///< each fifth of a room judged by a calibration fitted on the others
  std::uint64_t images = 0;
  std::vector<std::string> warnings;  ///< for a person: images that were left out
};

/// Fits the weights of the cues, the slope of the probabilities, the weights of evidence and the
/// threshold of 'unknown' anew to labelled `recordings` that the model was not trained on; its
/// machines stay as they are. The threshold leaves the wanted fraction of these frames 'unknown' as
/// a recognizer sees them, in the order of each recording. Frames of places that the model does not
/// know are left out. From then on these frames are the ones that judge the model when it learns
/// on. Throws Error if no frame is left; Cancelled if `progress` asks for it.
Recalibration recalibrate(Model model, const std::vector<RecordingOpener>& recordings,
                          unsigned threads = 0, const Progress& progress = {});

}  // namespace place_recognition
