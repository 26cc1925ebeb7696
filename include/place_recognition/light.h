#pragma once

namespace place_recognition {

/// A change of light as one gain per channel: the camera's exposure and white balance do not fully
/// compensate for sun and lamps.
struct Light {
  double red = 1;
  double green = 1;
  double blue = 1;
};

}  // namespace place_recognition
