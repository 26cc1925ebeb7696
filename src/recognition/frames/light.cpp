#include "recognition/frames/light.h"

#include <cassert>
#include <opencv2/core.hpp>

namespace place_recognition {
namespace {

/// Look-up table of the products of 0..255 with each gain, one channel a gain.
cv::Mat productTable(const std::vector<double>& gains) {
  cv::Mat table(1, 256, CV_8UC(static_cast<int>(gains.size())));
  for (int value = 0; value < 256; ++value) {
    for (std::size_t c = 0; c < gains.size(); ++c) {
      table.ptr(0, value)[c] = cv::saturate_cast<uchar>(gains[c] * value);
    }
  }
  return table;
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
  const std::vector<double> gains =
      image.channels() == 3 ? std::vector<double>{light.blue, light.green, light.red}
                            : std::vector<double>{(light.red + light.green + light.blue) / 3};
  cv::LUT(image, productTable(gains), changed);
}

}  // namespace place_recognition
