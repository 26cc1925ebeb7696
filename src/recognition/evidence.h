#pragma once

#include <Eigen/Core>

#include "place_recognition/calibration.h"

namespace place_recognition {

/// How much speaks for any of the places at all, 0..1: the largest sigmoid before normalisation.
/// Probabilities cannot tell: they sum to one also where every machine says no.
double evidence(const Calibration& calibration, const Eigen::RowVectorXd& margins);

}  // namespace place_recognition
