#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <random>
#include <string>
#include <vector>

#include "place_recognition/light.h"

namespace place_recognition {

/// The products of the gains.
inline Light operator*(const Light& a, const Light& b) {
  return {a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/// Darker, brighter, warmer and colder light, by about the amounts for which automatic exposure and
/// white balance fail to compensate.
const std::vector<Light>& otherLights();

/// Draws the light of each image at random, stratified: as many consecutive images of a room as
/// there are otherLights() get each of them once.
class LightDraw {
 public:
  explicit LightDraw(std::uint64_t seed) : random_(seed) {}

  /// For the next image of `room`.
  Light next(const std::string& room);

 private:
  std::mt19937_64 random_;
  std::map<std::string, std::vector<Light>> left_;  // of each room, in its current round
};

/// `image` (CV_8UC3 BGR or CV_8UC1 grey) in that light, saturated at white.
cv::Mat inLight(const cv::Mat& image, const Light& light);

/// The same into `changed`, whose memory is reused.
void changeLight(const cv::Mat& image, const Light& light, cv::Mat& changed);

}  // namespace place_recognition
