#pragma once

#include <opencv2/core/mat.hpp>

#include "features/crfh_descriptor.h"

namespace place_recognition {

/// Extracts columns left..left + n - 1 of row `y` of a channel as integers centred on zero, which
/// minimizes rounding when they are filtered: R + G + B for L, R - G for C1, R + G - 2 B for C2,
/// minus the middle of the range. A grey image has R = G = B. `image` is CV_8UC3 (BGR) or CV_8UC1.
void extractChannelRow(const cv::Mat& image, Channel channel, int y, int left, int n, float* row);

/// Meaning of the numbers in such a row: grey levels = unit * (number + middle).
struct ChannelScale {
  double unit;
  double middle;
};
ChannelScale channelScale(Channel channel);

}  // namespace place_recognition
