#pragma once

#include "learning/folds.h"
#include "place_recognition/model.h"
#include "recognition/training/held_out.h"

namespace place_recognition {

/// What held-out margins tell about a model.
struct Calibrated {
  Calibration calibration;       ///< fitted on all of them
  double unknown_threshold = 0;  ///< evidence that the wanted share of them stays below
  double unknown = 0;            ///< share of each fold below the limit of the others
  Validation validation;         ///< each fold judged by a calibration fitted on the others
};

/// Fits and judges the calibration. `false_alarm_rate`: see UnknownOptions.
Calibrated calibrate(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                     const std::vector<Fold>& folds, double false_alarm_rate);

}  // namespace place_recognition
