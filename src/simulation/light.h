#pragma once

#include "simulation/simulation.h"
#include "simulation/texture.h"

/// Radiance of luminous things: linear B, G, R; 1 is 100 cd/m^2.
namespace place_recognition::simulation {

/// A fluorescent tube behind its diffuser, about 4000 K and a little green.
const Vec3 kTubeRadiance(11.5f, 16.0f, 17.5f);
/// A bulb in a shade of cloth, about 2700 K.
const Vec3 kShadeRadiance(3.0f, 7.0f, 12.0f);
const Vec3 kScreenRadiance(1.3f, 1.1f, 1.0f);

struct Daylight {
  Vec3 sky;       ///< radiance of the view through a window, on average: lights the room
  Vec3 outdoors;  ///< radiance of white in the picture of the outdoors
  Vec3 sun;       ///< irradiance of a surface that faces the sun; zero: hidden
  Vec3 to_sun;    ///< unit
};

inline Daylight daylight(Condition condition) {
  // From the side of both outer walls, and low enough to reach far into the rooms.
  const Vec3 to_sun = cv::normalize(Vec3(-0.62f, 0.58f, 0.42f));
  switch (condition) {
    case Condition::kSunny:
      return {{26.0f, 24.0f, 22.0f}, {62.0f, 60.0f, 58.0f}, {300.0f, 400.0f, 470.0f}, to_sun};
    case Condition::kNight:
      return {{0.02f, 0.02f, 0.02f}, {1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, to_sun};
    case Condition::kCloudy:
      break;
  }
  return {{22.0f, 20.0f, 18.0f}, {32.0f, 30.0f, 28.0f}, {0.0f, 0.0f, 0.0f}, to_sun};
}

}  // namespace place_recognition::simulation
