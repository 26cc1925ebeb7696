#include "tuning/next_run.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace place_recognition {
namespace {

constexpr double kLeastPart = 0.8;      // of width and height that remain visible
constexpr double kMaxBlur = 1.0 / 400;  // sigma, as a fraction of the width
constexpr double kErrorOfLight = 0.05;  // maximum, of the estimated gain

}  // namespace

NextRun::NextRun(std::uint64_t seed, bool other_light)
    : random_(seed), light_draw_(seed), other_light_(other_light) {}

ChangedImage NextRun::change(const cv::Mat& image, const std::string& place) {
  ChangedImage changed{framed(image), {}};
  const double sigma = uniform(0, kMaxBlur) * image.cols;
  if (sigma > 0.3) cv::GaussianBlur(changed.image, changed.image, {}, sigma);
  if (!other_light_) return changed;
  const Light light = light_draw_.next(place);
  changed.image = inLight(changed.image, light);
  const auto found = [this](double gain) {
    return (1 + uniform(-kErrorOfLight, kErrorOfLight)) / gain;
  };
  changed.correction.red = found(light.red);
  changed.correction.green = found(light.green);
  changed.correction.blue = found(light.blue);
  return changed;
}

/// Unlike std::uniform_real_distribution, the same with every standard library.
double NextRun::uniform(double least, double most) {
  return least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53;
}

/// A part of the image, enlarged to the size of the whole image.
cv::Mat NextRun::framed(const cv::Mat& image) {
  const double part = uniform(kLeastPart, 1);
  const int width = std::max(1, static_cast<int>(std::lround(part * image.cols)));
  const int height = std::max(1, static_cast<int>(std::lround(part * image.rows)));
  const int x = static_cast<int>(std::floor(uniform(0, 1) * (image.cols - width + 1)));
  const int y = static_cast<int>(std::floor(uniform(0, 1) * (image.rows - height + 1)));
  cv::Mat result;
  cv::resize(image(cv::Rect(x, y, width, height)), result, image.size(), 0, 0, cv::INTER_LINEAR);
  return result;
}

}  // namespace place_recognition
