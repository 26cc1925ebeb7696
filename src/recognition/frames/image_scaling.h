#pragma once

#include <opencv2/core/mat.hpp>

#include "place_recognition/model.h"

namespace place_recognition {

/// `image`, or if it is wider than `max_width` > 0 pixels, a copy of that width in `buffer`.
const cv::Mat& scaledDown(const cv::Mat& image, int max_width, cv::Mat& buffer);

/// `image` (CV_8UC3 or CV_8UC1) in `size`, which is at least as large in both directions. Takes a
/// pixel for the mean brightness over its area: the mean of the enlarged image over that area is
/// the pixel again. Plain interpolation takes it for the brightness at its centre and so smooths
/// the image, which lowers the responses of derivatives.
cv::Mat enlarged(const cv::Mat& image, cv::Size size);

/// Brings images to the size that a model works at, so that a scale in pixels means the same detail
/// of the room whatever the camera sends: the longer side becomes that of the images it was
/// trained on, the aspect ratio stays. Keeps its buffers: one per thread.
class ImageScaler {
 public:
  /// An image is enlarged by no more than this; a smaller one shows too little to be told apart.
  static constexpr double kMaxEnlargement = 4;

  /// `trained`: what the model was trained on; if that is not known, images are scaled down to
  /// `max_width` (0: never) and never enlarged.
  ImageScaler(const ImageProfile& trained, int max_width);

  /// The size that an image of `size` is brought to.
  cv::Size sizeFor(cv::Size size) const;

  /// `image` (CV_8UC3 or CV_8UC1, not empty) itself, or a scaled copy that stays valid until the
  /// next call.
  const cv::Mat& scaled(const cv::Mat& image);

 private:
  int max_width_;
  cv::Size trained_;        ///< no wider than max_width_; 0 x 0: not known
  bool trained_on_scaled_;  ///< images wider than max_width_, or of a size not known
  cv::Mat buffer_;
};

}  // namespace place_recognition
