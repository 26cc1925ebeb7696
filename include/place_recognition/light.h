#pragma once

namespace place_recognition {

/// A change of light, as a gain of each channel: the camera's exposure and white balance do not
/// follow the sun and the lamps.
struct Light {
  double red = 1;
  double green = 1;
  double blue = 1;
};

}  // namespace place_recognition
