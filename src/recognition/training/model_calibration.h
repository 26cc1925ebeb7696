#pragma once

#include <vector>

#include "place_recognition/model.h"
#include "recognition/training/calibration_set.h"
#include "recognition/training/combination.h"

namespace place_recognition {

/// The calibration of a model from held-out decision values.
struct Calibrated {
  Calibration calibration;       ///< fitted on all frames, evidence on those that judge "unknown"
  double unknown_threshold = 0;  ///< evidence below which the requested fraction of these lies
  double unknown = 0;            ///< fraction of each fold below the threshold of the others
  Validation validation;         ///< each fold judged by a calibration fitted on the others
};

/// Fits the calibration and estimates its quality. `held_out`: decision values of all cues together
/// for the samples of `set`. `false_alarm_rate`: see UnknownOptions.
Calibrated calibrate(const CombinedValues& held_out, const CalibrationSet& set,
                     double false_alarm_rate);

}  // namespace place_recognition
