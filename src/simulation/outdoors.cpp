#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "simulation/patterns.h"
#include "simulation/pictures.h"

namespace place_recognition::simulation {
namespace {

const cv::Size kSize{2048, 1024};
const int kHorizon = kSize.height / 2;

/// The colours of a day or a night.
struct Light {
  cv::Scalar zenith, horizon, cloud, wall, window, tree, ground;
  double clouds;     ///< fraction of the cloud's colour at its thickest point
  float lit_window;  ///< fraction of the windows with a lamp behind
};

Light lightOf(Condition condition) {
  switch (condition) {
    case Condition::kSunny:
      return {rgb(120, 158, 218),
              rgb(196, 214, 236),
              rgb(250, 250, 250),
              rgb(206, 172, 134),
              rgb(70, 84, 104),
              rgb(66, 92, 38),
              rgb(110, 118, 74),
              0.5,
              0.0f};
    case Condition::kNight:
      return {rgb(10, 12, 20),
              rgb(44, 36, 32),
              rgb(30, 26, 26),
              rgb(22, 18, 16),
              rgb(10, 10, 12),
              rgb(8, 10, 8),
              rgb(26, 22, 16),
              0.3,
              0.16f};
    case Condition::kCloudy:
      break;
  }
  return {rgb(222, 226, 230),
          rgb(204, 208, 212),
          rgb(160, 168, 176),
          rgb(124, 112, 102),
          rgb(62, 68, 76),
          rgb(50, 60, 42),
          rgb(84, 88, 74),
          0.7,
          0.05f};
}

void drawSky(cv::Mat& picture, Random& random, const Light& light) {
  const cv::Mat field = 0.6 * noise(random, kSize, {6, 5}) + 0.4 * noise(random, kSize, {20, 16});
  for (int y = 0; y < kSize.height; ++y) {
    const double height = std::max(0.0, 1.0 - static_cast<double>(y) / kHorizon);
    const cv::Scalar clear = light.horizon + (light.zenith - light.horizon) * height;
    for (int x = 0; x < kSize.width; ++x) {
      const double fraction =
          light.clouds * std::clamp(2.5 * (field.at<float>(y, x) - 0.4), 0.0, 1.0);
      for (int c = 0; c < 3; ++c) {
        picture.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<uchar>(clear[c] + fraction * (light.cloud[c] - clear[c]));
      }
    }
  }
}

void drawHouse(cv::Mat& picture, Random& random, const Light& light, int left, int right) {
  const int roof = kHorizon - 60 - random.integer(110);
  const cv::Scalar wall = light.wall * random.uniform(0.7f, 1.15f);
  cv::rectangle(picture, {left, roof}, {right, kSize.height}, wall, cv::FILLED);
  cv::rectangle(picture, {left, roof}, {right, roof + 8}, wall * 0.6, cv::FILLED);
  for (int y = roof + 24; y < kSize.height - 30; y += 44) {
    for (int x = left + 14; x < right - 22; x += 34) {
      const bool lit = random.chance(light.lit_window);
      cv::rectangle(picture, {x, y, 18, 26}, lit ? rgb(255, 206, 130) : light.window, cv::FILLED);
      cv::rectangle(picture, {x, y, 18, 26}, wall * 1.15, 1);
    }
  }
}

void drawTree(cv::Mat& picture, Random& random, const Light& light) {
  const cv::Point foot(random.integer(kSize.width), kHorizon + 40 + random.integer(120));
  const int size = 50 + random.integer(60);
  cv::line(picture, foot, foot - cv::Point(0, size), light.tree * 0.5, 9);
  for (int i = 0; i < 60; ++i) {
    const cv::Point leaf =
        foot +
        cv::Point(static_cast<int>(0.5f * static_cast<float>(size) * random.normal()),
                  -size - static_cast<int>(0.4f * static_cast<float>(size) * random.normal()));
    cv::circle(picture, leaf, 6 + random.integer(12), light.tree * random.uniform(0.6f, 1.3f),
               cv::FILLED, cv::LINE_AA);
  }
}

}  // namespace

cv::Mat outdoors(Random& random, Condition condition) {
  const Light light = lightOf(condition);
  cv::Mat picture(kSize, CV_8UC3);
  drawSky(picture, random, light);
  int x = 0;
  while (x < kSize.width) {
    const int width = 160 + random.integer(260);
    if (random.chance(0.75f)) drawHouse(picture, random, light, x, x + width);
    x += width;
  }
  cv::rectangle(picture, {0, kHorizon + 160}, {kSize.width, kSize.height}, light.ground,
                cv::FILLED);
  for (int i = 0; i < 14; ++i) drawTree(picture, random, light);
  return picture;
}

}  // namespace place_recognition::simulation
