#include "recognition/frames/light.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/core.hpp>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// A gain as a fixed-point number with 16 fractional bits; from 256 on, every level except 0
/// becomes white.
std::uint32_t fixedPoint(double gain) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(gain, 0.0, 256.0) * (1 << 16)));
}

PLACE_RECOGNITION_TARGET_CLONES
void multiply(const std::uint8_t* __restrict levels, const std::uint32_t* __restrict gains, int n,
              std::uint8_t* __restrict products) {
  for (int i = 0; i < n; ++i) {
    const std::uint32_t product = (levels[i] * gains[i] + (1 << 15)) >> 16;
    products[i] = static_cast<std::uint8_t>(product < 255 ? product : 255);
  }
}

}  // namespace

const std::vector<Light>& otherLights() {
  static const std::vector<Light> lights{
      {0.75, 0.75, 0.75}, {1.3, 1.3, 1.3}, {1.1, 1, 0.9}, {0.9, 1, 1.1}};
  return lights;
}

Light LightDraw::next(const std::string& room) {
  std::vector<Light>& left = left_[room];
  if (left.empty()) left = otherLights();
  const auto drawn = left.begin() + static_cast<std::ptrdiff_t>(random_() % left.size());
  const Light light = *drawn;
  left.erase(drawn);
  return light;
}

cv::Mat inLight(const cv::Mat& image, const Light& light) {
  cv::Mat changed;
  changeLight(image, light, changed);
  return changed;
}

void changeLight(const cv::Mat& image, const Light& light, cv::Mat& changed) {
  assert(image.type() == CV_8UC3 || image.type() == CV_8UC1);
  std::vector<double> channels{light.blue, light.green, light.red};
  if (image.channels() == 1) channels = {(light.red + light.green + light.blue) / 3};
  std::vector<std::uint32_t> gains;  // for each number in a row
  for (int x = 0; x < image.cols; ++x) {
    for (double gain : channels) gains.push_back(fixedPoint(gain));
  }
  changed.create(image.size(), image.type());
  for (int y = 0; y < image.rows; ++y) {
    multiply(image.ptr(y), gains.data(), static_cast<int>(gains.size()), changed.ptr(y));
  }
}

}  // namespace place_recognition
