#include "recognition/frames/colour_normalization.h"

#include <cassert>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>

#include "base/require.h"
#include "features/logarithmic_levels.h"

namespace place_recognition {
namespace {

/// Target of the mean level, about that of a well exposed room.
constexpr double kMeanLevel = 110;

}  // namespace

ColourNormalization colourNormalization(const std::string& name, const std::string& key) {
  static const std::map<std::string, ColourNormalization> kNames{
      {"none", ColourNormalization::kNone},
      {"brightness", ColourNormalization::kBrightness},
      {"grey-world", ColourNormalization::kGreyWorld},
      {"run", ColourNormalization::kRun}};
  const auto found = kNames.find(name);
  requireOption(found != kNames.end(), key, name, "none, brightness, grey-world or run");
  return found->second;
}

Eigen::RowVector3d logColour(const cv::Mat& image) {
  assert(image.type() == CV_8UC3 || image.type() == CV_8UC1);
  const cv::Scalar mean = cv::mean(image);
  Eigen::RowVector3d colour;
  for (int c = 0; c < 3; ++c)
    colour[c] = std::log(std::max(1.0, mean[image.channels() == 3 ? c : 0]));
  return colour;
}

Eigen::RowVector3d logGains(const Light& light) {
  return Eigen::Array3d(light.blue, light.green, light.red).log().matrix().transpose();
}

void NormalizedImage::set(const cv::Mat& image, const Eigen::RowVector3d& colour,
                          const Light& correction) {
  image_ = &image;
  colour_ = colour;
  correction_ = correction;
  for (Derived& derived : normalized_) derived.computed = false;
  for (Derived& derived : logarithms_) derived.computed = false;
}

const cv::Mat& NormalizedImage::in(ColourNormalization normalization) {
  if (normalization == ColourNormalization::kNone) return *image_;
  const Light light = gains(normalization);
  if (light.red == 1 && light.green == 1 && light.blue == 1) return *image_;
  Derived& normalized = normalized_[static_cast<std::size_t>(normalization)];
  if (!normalized.computed) changeLight(*image_, light, normalized.image);
  normalized.computed = true;
  return normalized.image;
}

const cv::Mat& NormalizedImage::logarithms(ColourNormalization normalization) {
  Derived& logarithms = logarithms_[static_cast<std::size_t>(normalization)];
  if (!logarithms.computed) takeLogarithms(in(normalization), logarithms.image);
  logarithms.computed = true;
  return logarithms.image;
}

Light NormalizedImage::gains(ColourNormalization normalization) const {
  const Eigen::RowVector3d means = colour_.array().exp();
  switch (normalization) {
    case ColourNormalization::kBrightness: {
      const double gain = kMeanLevel / means.mean();
      return {gain, gain, gain};
    }
    case ColourNormalization::kGreyWorld:
      return {kMeanLevel / means[2], kMeanLevel / means[1], kMeanLevel / means[0]};
    case ColourNormalization::kRun:
      return correction_;
    default:
      return {};
  }
}

}  // namespace place_recognition
