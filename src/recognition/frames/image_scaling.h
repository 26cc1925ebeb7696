#pragma once

#include <opencv2/core/mat.hpp>

#include "place_recognition/model.h"

namespace place_recognition {

/// `image`, or a copy of width `max_width` in `buffer` if it is wider than `max_width` > 0 pixels.
const cv::Mat& scaledDown(const cv::Mat& image, int max_width, cv::Mat& buffer);

/// `image` (CV_8UC3 or CV_8UC1) enlarged to `size`, which is at least as large in both directions.
/// A pixel is treated as the mean brightness over its area: the mean of the enlarged image over
/// that area equals the pixel. Plain interpolation treats it as the brightness at its centre and
/// therefore smooths the image, which weakens the responses of derivatives.
cv::Mat enlarged(const cv::Mat& image, cv::Size size);

/// Scales images to the working size of a model, so that a scale in pixels means the same detail of
/// the room for every camera: the longer side becomes that of the training images, and the aspect
/// ratio is kept. Keeps its buffers: use one per thread.
class ImageScaler {
 public:
  /// Maximum enlargement; a smaller image shows too little to be distinguished.
  static constexpr double kMaxEnlargement = 4;

  /// `trained`: the training images; if they are not known, images are scaled down to `max_width`
  /// (0: never) and never enlarged.
  ImageScaler(const ImageProfile& trained, int max_width);

  /// The working size for an image of `size`.
  cv::Size sizeFor(cv::Size size) const;

  /// `image` (CV_8UC3 or CV_8UC1, not empty) itself, or a scaled copy that stays valid until the
  /// next call.
  const cv::Mat& scaled(const cv::Mat& image);

 private:
  int max_width_;
  cv::Size trained_;        ///< no wider than max_width_; 0 x 0: unknown
  bool trained_on_scaled_;  ///< on images wider than max_width_, or of unknown size
  cv::Mat buffer_;
};

}  // namespace place_recognition
