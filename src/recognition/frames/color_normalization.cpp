#include "recognition/frames/color_normalization.h"

#include <cassert>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// The mean that pictures are brought to: about that of a well exposed room.
constexpr double kMeanLevel = 110;

}  // namespace

ColorNormalization colorNormalization(const std::string& name) {
  static const std::map<std::string, ColorNormalization> kNames{
      {"none", ColorNormalization::kNone},
      {"brightness", ColorNormalization::kBrightness},
      {"grey-world", ColorNormalization::kGreyWorld},
      {"run", ColorNormalization::kRun}};
  const auto found = kNames.find(name);
  if (found == kNames.end()) {
    throw Error("Option 'normalize' of a cue is '" + name +
                "'; give none, brightness, grey-world or run.");
  }
  return found->second;
}

Eigen::RowVector3d logColor(const cv::Mat& image) {
  assert(image.type() == CV_8UC3 || image.type() == CV_8UC1);
  const cv::Scalar mean = cv::mean(image);
  Eigen::RowVector3d color;
  for (int c = 0; c < 3; ++c)
    color[c] = std::log(std::max(1.0, mean[image.channels() == 3 ? c : 0]));
  return color;
}

Eigen::RowVector3d logGains(const Light& light) {
  return Eigen::Array3d(light.blue, light.green, light.red).log().matrix().transpose();
}

void NormalizedImage::set(const cv::Mat& image, const Eigen::RowVector3d& color,
                          const Light& correction) {
  image_ = &image;
  color_ = color;
  correction_ = correction;
  is_made_.fill(false);
}

const cv::Mat& NormalizedImage::in(ColorNormalization normalization) {
  if (normalization == ColorNormalization::kNone) return *image_;
  const auto index = static_cast<std::size_t>(normalization);
  const Light light = gains(normalization);
  if (light.red == 1 && light.green == 1 && light.blue == 1) return *image_;
  if (!is_made_[index]) {
    changeLight(*image_, light, made_[index]);
    is_made_[index] = true;
  }
  return made_[index];
}

Light NormalizedImage::gains(ColorNormalization normalization) const {
  const Eigen::RowVector3d means = color_.array().exp();
  switch (normalization) {
    case ColorNormalization::kBrightness: {
      const double gain = kMeanLevel / means.mean();
      return {gain, gain, gain};
    }
    case ColorNormalization::kGreyWorld:
      return {kMeanLevel / means[2], kMeanLevel / means[1], kMeanLevel / means[0]};
    case ColorNormalization::kRun:
      return correction_;
    default:
      return {};
  }
}

}  // namespace place_recognition
