#pragma once

#include <cstdint>
#include <random>

#include "recognition/training/samples.h"

namespace place_recognition {

/// Changes images as the next run might differ from this one: the robot stands a little nearer and
/// to the side, the camera is less sharp, and, if requested, the light is different. For cues that
/// follow the light of the recording, the estimated gains are off by up to 5 %, as in a stream of
/// frames. The changes are random and reproducible for the same seed and images.
class NextRun {
 public:
  NextRun(std::uint64_t seed, bool other_light);

  /// Changes the next image of `place`; the size stays the same.
  ChangedImage change(const cv::Mat& image, const std::string& place);

 private:
  double uniform(double least, double most);
  cv::Mat framed(const cv::Mat& image);

  std::mt19937_64 random_;
  LightDraw light_draw_;
  bool other_light_;
};

}  // namespace place_recognition
