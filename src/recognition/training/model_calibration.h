#pragma once

#include "learning/folds.h"
#include "place_recognition/model.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// What held-out decision values tell about a model.
struct Calibrated {
  Calibration calibration;       ///< fitted on all of them
  double unknown_threshold = 0;  ///< evidence that the wanted fraction of them stays below
  double unknown = 0;            ///< fraction of each fold below the limit of the others
  Validation validation;         ///< each fold judged by a calibration fitted on the others
};

/// Fits and judges the calibration. `false_alarm_rate`: see UnknownOptions.
Calibrated calibrate(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                     const std::vector<Fold>& folds, double false_alarm_rate);

/// The largest limit that at most `fraction` of the values lie below; 0 if there are none.
double quantile(std::vector<double> values, double fraction);

}  // namespace place_recognition
