#pragma once

#include <string>
#include <vector>

#include "learning/folds.h"
#include "place_recognition/calibration.h"
#include "place_recognition/camera_correlation.h"
#include "recognition/training/held_out_values.h"

namespace place_recognition {

/// Learns the correlation of the errors of `cameras` (SampleOrigin::camera) from the moments of a
/// recording that two of them saw, by the held-out log odds that each gives the true place. A pair
/// with few common moments gets the mean of the others, or kUnknownCorrelation if there are none.
/// Empty for a single camera, and for more than kMaxCameras, which cannot belong to one robot. Only
/// the first rows of `held_out`, one per sample, are used.
CameraCorrelation learnCameraCorrelation(const std::vector<std::string>& cameras,
                                         const std::vector<SampleOrigin>& samples,
                                         const HeldOutValues& held_out,
                                         const Calibration& calibration);

}  // namespace place_recognition
