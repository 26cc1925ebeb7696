#include "simulation/texture.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace place_recognition::simulation {
namespace {

float linear(float srgb) {
  const float v = srgb / 255.0f;
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

int powerOfTwo(int side) {
  int result = 1;
  while (result < side) result *= 2;
  return result;
}

cv::Mat encoded(const cv::Mat& linear_picture) {
  cv::Mat root, bytes, padded;
  cv::sqrt(linear_picture, root);
  root.convertTo(bytes, CV_8UC3, 255.0);
  cv::cvtColor(bytes, padded, cv::COLOR_BGR2BGRA);
  return padded;
}

}  // namespace

Vec3 colour(float red, float green, float blue) {
  return {linear(blue), linear(green), linear(red)};
}

Texture::Texture(const cv::Mat& picture) {
  CV_Assert(picture.type() == CV_8UC3 && !picture.empty());
  cv::Mat table(1, 256, CV_32F);
  for (int i = 0; i < 256; ++i) table.at<float>(i) = linear(static_cast<float>(i));

  cv::Mat level(picture.size(), CV_32FC3);
  picture.forEach<cv::Vec3b>([&](const cv::Vec3b& pixel, const int* at) {
    for (int c = 0; c < 3; ++c) level.at<Vec3>(at)[c] = table.at<float>(pixel[c]);
  });
  cv::resize(level, level, {powerOfTwo(level.cols), powerOfTwo(level.rows)}, 0, 0, cv::INTER_AREA);

  const cv::Scalar mean = cv::mean(level);
  average_ =
      Vec3(static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]));
  levels_.push_back(encoded(level));
  while (level.cols > 1 || level.rows > 1) {
    cv::Mat half;
    cv::resize(level, half, {std::max(1, level.cols / 2), std::max(1, level.rows / 2)}, 0, 0,
               cv::INTER_AREA);
    level = half;
    levels_.push_back(encoded(level));
  }
}

Vec3 Texture::sample(float s, float t, float extent_s, float extent_t) const {
  const float width = extent_s * static_cast<float>(levels_[0].cols);
  const float height = extent_t * static_cast<float>(levels_[0].rows);
  // A long thin footprint (a floor seen at a grazing angle) is a compromise between the blur of its
  // long side and the aliasing of its short one; the samples of a pixel average the rest.
  const float extent = std::max(std::min(width, height), std::max(width, height) * 0.5f);
  const float level =
      std::min(std::log2(std::max(extent, 1.0f)), static_cast<float>(levels_.size() - 1));
  const int fine = static_cast<int>(level);
  const int coarse = std::min(fine + 1, static_cast<int>(levels_.size()) - 1);
  const float weight = level - static_cast<float>(fine);
  Vec3 root = bilinear(fine, s, t);
  if (weight > 0.0f && coarse != fine) {
    root += weight * (bilinear(coarse, s, t) - root);
  }
  return root.mul(root);
}

Vec3 Texture::bilinear(int level, float s, float t) const {
  const cv::Mat& picture = levels_[static_cast<std::size_t>(level)];
  const float x = (s - std::floor(s)) * static_cast<float>(picture.cols) - 0.5f;
  const float y = (t - std::floor(t)) * static_cast<float>(picture.rows) - 0.5f;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const float wx = x - static_cast<float>(x0);
  const float wy = y - static_cast<float>(y0);
  const int left = x0 & (picture.cols - 1);
  const int right = (x0 + 1) & (picture.cols - 1);
  const cv::Vec4b* upper = picture.ptr<cv::Vec4b>(y0 & (picture.rows - 1));
  const cv::Vec4b* lower = picture.ptr<cv::Vec4b>((y0 + 1) & (picture.rows - 1));
  const float w00 = (1.0f - wx) * (1.0f - wy) / 255.0f;
  const float w01 = wx * (1.0f - wy) / 255.0f;
  const float w10 = (1.0f - wx) * wy / 255.0f;
  const float w11 = wx * wy / 255.0f;
  Vec3 result;
  for (int c = 0; c < 3; ++c) {
    result[c] =
        w00 * upper[left][c] + w01 * upper[right][c] + w10 * lower[left][c] + w11 * lower[right][c];
  }
  return result;
}

}  // namespace place_recognition::simulation
