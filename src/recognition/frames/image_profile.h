#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition {

/// Some rows of `image`, evenly spread over its height, as an image that shares its memory: enough
/// to judge the whole image.
cv::Mat sampledRows(const cv::Mat& image);

/// Statistics of an image, from sampledRows().
struct ImageStatistics {
  double brightness = 0;  ///< mean of all pixels and channels, 0..255
  double contrast = 0;    ///< the largest standard deviation of a channel
  bool colour = false;    ///< the channels differ by more than JPEG artefacts of a grey image
};

/// `image`: CV_8UC3 or CV_8UC1, not empty.
ImageStatistics statisticsOf(const cv::Mat& image);

/// Whether all pixels are equal except for sensor noise, as in no view of a room: the lens is
/// covered, or the camera is starting, is blinded, or has lost its signal. Such images are neither
/// learned nor recognized.
bool isUniform(const ImageStatistics& image);

/// The problem of a uniform image; follows a noun for the image.
constexpr const char* kUniformProblem = "shows nothing but one colour";

/// The size at which `recordings` are learned: the smallest Recording::usualSize(), because detail
/// can be removed from an image but not added; and the range of levels of all recordings. Not known
/// if no recording has an image.
ImageProfile commonSize(const std::vector<RecordingOpener>& recordings, const Progress& progress);

/// Widens the ranges of `profile` to include `image`, or all of `others`; its size stays.
void include(const ImageStatistics& image, ImageProfile& profile);
void include(const ImageProfile& others, ImageProfile& profile);

}  // namespace place_recognition
