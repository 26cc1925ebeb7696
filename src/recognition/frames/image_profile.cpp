#include "recognition/frames/image_profile.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <opencv2/core.hpp>

#include "place_recognition/level_range.h"

namespace place_recognition {
namespace {

constexpr int kRows = 48;

/// Whether any pixel of a CV_8UC3 image is not grey.
bool showsColour(const cv::Mat& image) {
  constexpr int kTolerance = 2;
  for (int y = 0; y < image.rows; ++y) {
    const std::uint8_t* pixel = image.ptr(y);
    for (int x = 0; x < image.cols; ++x, pixel += 3) {
      const auto [low, high] = std::minmax({pixel[0], pixel[1], pixel[2]});
      if (high - low > kTolerance) return true;
    }
  }
  return false;
}

}  // namespace

cv::Mat sampledRows(const cv::Mat& image) {
  // A view whose row step skips the rows between.
  const int step = std::max(1, image.rows / kRows);
  return {(image.rows + step - 1) / step, image.cols, image.type(),
          const_cast<std::uint8_t*>(image.data), image.step * static_cast<std::size_t>(step)};
}

ImageStatistics statisticsOf(const cv::Mat& image) {
  assert(!image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1));
  const cv::Mat rows = sampledRows(image);
  cv::Scalar mean, deviation;
  cv::meanStdDev(rows, mean, deviation);
  const int channels = image.channels();
  ImageStatistics statistics;
  for (int c = 0; c < channels; ++c) {
    statistics.brightness += mean[c] / channels;
    statistics.contrast = std::max(statistics.contrast, deviation[c]);
  }
  statistics.colour = channels == 3 && showsColour(rows);
  return statistics;
}

bool isUniform(const ImageStatistics& image) {
  // Sensor noise has a deviation of 1 to 4; the flattest of 1114 images of rooms and floors has 11.
  constexpr double kNoise = 5;
  return image.contrast <= kNoise;
}

ImageProfile commonSize(const std::vector<RecordingOpener>& recordings, const Progress& progress) {
  ImageProfile smallest;
  LevelRange levels;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    report(progress, "Looking at the images",
           static_cast<double>(r) / static_cast<double>(recordings.size()));
    const std::unique_ptr<Recording> recording = recordings[r]();
    const cv::Size size = recording->usualSize();
    levels = united(levels, recording->levelRange());
    const bool smaller =
        std::max(size.width, size.height) < std::max(smallest.width, smallest.height);
    if (size.empty() || (smallest.known() && !smaller)) continue;
    smallest.width = size.width;
    smallest.height = size.height;
  }
  smallest.levels = levels;
  return smallest;
}

void include(const ImageStatistics& image, ImageProfile& profile) {
  profile.colour = profile.colour || image.colour;
  profile.darkest = std::min(profile.darkest, image.brightness);
  profile.brightest = std::max(profile.brightest, image.brightness);
}

void include(const ImageProfile& others, ImageProfile& profile) {
  profile.colour = profile.colour || others.colour;
  profile.darkest = std::min(profile.darkest, others.darkest);
  profile.brightest = std::max(profile.brightest, others.brightest);
  profile.levels = united(profile.levels, others.levels);
}

}  // namespace place_recognition
