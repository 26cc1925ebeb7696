#pragma once

#include <cstdint>
#include <random>

#include "recognition/training/samples.h"

namespace place_recognition {

/// Changes images as the next run would differ from this one: the robot stands a little nearer
/// and to the side, the camera is less sharp, and, if asked for, the light has changed. Cues that
/// follow the light of the recording find it to within a twentieth, as in a stream of frames. Draws
/// at random, the same for the same seed and images.
class NextRun {
 public:
  NextRun(std::uint64_t seed, bool other_light);

  /// For the next image of `place`; of the same size.
  ChangedImage change(const cv::Mat& image, const std::string& place);

 private:
  double uniform(double least, double most);
  cv::Mat framed(const cv::Mat& image);

  std::mt19937_64 random_;
  LightDraw light_draw_;
  bool other_light_;
};

}  // namespace place_recognition
