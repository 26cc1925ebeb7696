#pragma once

#include <opencv2/core/mat.hpp>

#include "features/crfh_descriptor.h"

namespace place_recognition {

/// A channel of an image in whole numbers around zero, so that as little as possible is rounded when
/// it is filtered: R + G + B for L, R - G for C1, R + G - 2 B for C2, less the middle of the range.
/// A grey image has R = G = B. `image` is CV_8UC3 (BGR) or CV_8UC1; `plane` gets its size.
void extractPlane(const cv::Mat& image, Channel channel, cv::Mat_<float>& plane);

/// What the numbers in a plane mean: grey levels = unit * (number + middle).
struct PlaneScale {
  double unit;
  double middle;
};
PlaneScale planeScale(Channel channel);

}  // namespace place_recognition
