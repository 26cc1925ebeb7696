#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition {

/// Some rows of `image`, evenly over its height, as an image that shares its memory: enough to
/// judge it as a whole.
cv::Mat sampledRows(const cv::Mat& image);

/// One image as a whole, from sampledRows().
struct ImageStatistics {
  double brightness = 0;  ///< mean of all pixels and channels, 0..255
  double contrast = 0;    ///< the largest standard deviation of a channel
  bool colour = false;    ///< the channels differ by more than what decoding grey JPEG leaves
};

/// `image`: CV_8UC3 or CV_8UC1, not empty.
ImageStatistics statisticsOf(const cv::Mat& image);

/// Whether all pixels are equal but for the noise of a sensor, as in no view of a room: a covered
/// lens, a camera that starts, is blinded or has lost its signal. Such images are neither learned
/// nor recognized.
bool isUniform(const ImageStatistics& image);

/// What is wrong with a uniform image; follows a noun that stands for the image.
constexpr const char* kUniformProblem = "shows nothing but one colour";

/// The size that `runs` are learned at: that of the run whose first image is the smallest, because
/// detail can be taken from an image but not added; and the depth of all runs. Not known if no run
/// has an image. Reads the runs up to their first image.
ImageProfile commonSize(const std::vector<RecordingOpener>& recordings, const Progress& progress);

/// Widens the ranges of `profile` so that they hold `image`, or all of `others`; its size stays.
void include(const ImageStatistics& image, ImageProfile& profile);
void include(const ImageProfile& others, ImageProfile& profile);

}  // namespace place_recognition
