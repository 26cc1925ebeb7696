#pragma once

#include <opencv2/core.hpp>

#include "simulation/random.h"
#include "simulation/scene.h"

namespace place_recognition::simulation {

/// m above the floor, the height of the tripod in the thesis (section 3.2).
constexpr float kCameraHeight = 0.76f;

/// Position and direction of the camera.
struct View {
  Vec3 eye;            ///< m
  float yaw = 0.0f;    ///< rad, anticlockwise from x
  float pitch = 0.0f;  ///< rad, up
};

/// The view of a camera that is fixed to the first one, turned by `angle`, rad, about the vertical
/// through the eye.
View turned(View view, float angle);

/// The focal length in pixels of the Olympus C-3030ZOOM at wide angle (6.5 mm before a sensor
/// 7.18 mm wide: 58 degrees across) for an image `width` pixels wide.
float focalLength(int width);

/// Converts radiance (CV_32FC3, linear) to an image (CV_8UC3): vignetting, automatic exposure that
/// weights the middle of the image more, automatic white balance that corrects only part of the
/// light's colour, photon and readout noise, sRGB curve with a soft shoulder.
cv::Mat develop(const cv::Mat& radiance, Random random);

}  // namespace place_recognition::simulation
