#include "sample_image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace place_recognition {
namespace {

cv::Mat noiseAtAllScales() {
  cv::Mat_<cv::Vec3f> sum(480, 640, cv::Vec3f::all(128)), noise;
  cv::RNG random(1);
  for (int cell = 1; cell <= 64; cell *= 2) {
    noise.create(480 / cell + 2, 640 / cell + 2);
    random.fill(noise, cv::RNG::NORMAL, 0, 4 * std::sqrt(cell));
    cv::resize(noise, noise, sum.size(), 0, 0, cv::INTER_CUBIC);
    sum += noise;
  }
  cv::Mat image;
  sum.convertTo(image, CV_8UC3);
  return image;
}

}  // namespace

cv::Mat sampleImage(std::size_t number) {
  std::vector<cv::String> files;
  if (const char* data = std::getenv("PLACE_RECOGNITION_TEST_DATA")) {
    cv::glob(data + std::string("/nao_canteen/*.jpg"), files, true);
  }
  if (number >= files.size()) return noiseAtAllScales();
  cv::Mat image = cv::imread(files[number], cv::IMREAD_COLOR);
  cv::resize(image, image, {640, 480});
  return image;
}

}  // namespace place_recognition
