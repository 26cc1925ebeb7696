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

/// The ring of a mirror in an image (CV_8UC3 or CV_8UC1, 32 pixels or more on each side) or the
/// mean of several: of all circles around the middle of the image, the rim is that along which the
/// mean brightness falls most from inside to outside, and the inner circle, of the same centre,
/// that along which it falls most from outside to inside (the integro-differential operator of
/// Daugman 1993). Nothing if there is no such rim; without an inner circle, a quarter of the rim's
/// radius.
std::optional<MirrorRing> findMirror(const cv::Mat& image);

/// `options` with a mirror that is to be `found` in the first images of `runs`, or in `image`, now
/// `given`. Throws Error if there is none, naming the run or `name`.
TrainingOptions withMirror(TrainingOptions options, const std::vector<RecordingOpener>& recordings);
TrainingOptions withMirror(TrainingOptions options, const cv::Mat& image, const std::string& name);

}  // namespace place_recognition
