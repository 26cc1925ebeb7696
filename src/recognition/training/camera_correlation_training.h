#pragma once

#include <string>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/calibration.h"
#include "place_recognition/camera_correlation.h"
#include "recognition/training/cross_validation.h"

namespace place_recognition {

/// Correlation of the errors of `cameras` (SampleOrigin::camera) over the moments of a recording
/// that two of them saw, by the held-out log odds that each gives the true place. A pair that has
/// seen few moments together has the mean of the others, or kUnknownCorrelation if there is none.
/// Nothing for a single camera, and for more than kMaxCameras, which are not of one robot. Only the
/// first rows of `held_out` count, one per sample.
CameraCorrelation learnCameraCorrelation(const std::vector<std::string>& cameras,
                                         const std::vector<SampleOrigin>& samples,
                                         const HeldOutValues& held_out,
                                         const Calibration& calibration);

}  // namespace place_recognition
