#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "place_recognition/recording.h"
#include "place_recognition/training.h"
#include "place_recognition/training_options.h"
#include "recognition/frames/panorama.h"

namespace place_recognition {

/// Finds the ring of a mirror in an image (CV_8UC3 or CV_8UC1, at least 32 pixels on each side) or
/// in the mean of several. Among all circles around the middle of the image, the rim is the one at
/// which the mean brightness decreases most from inside to outside. The inner circle has the same
/// centre, and brightness decreases most from outside to inside (the integro-differential operator
/// of Daugman 1993). Nothing if there is no such rim; if there is no inner circle, its radius is a
/// quarter of the rim's.
std::optional<MirrorRing> findMirror(const cv::Mat& image);

/// `options` in which a mirror that is to be `found` is `given`, after the first images of
/// `recordings`, or `image`. Throws Error, naming the run or `name`, if there is none.
TrainingOptions withMirror(TrainingOptions options, const std::vector<RecordingOpener>& recordings);
TrainingOptions withMirror(TrainingOptions options, const cv::Mat& image, const std::string& name);

}  // namespace place_recognition
