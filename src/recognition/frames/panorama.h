#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "place_recognition/training_options.h"

namespace place_recognition {

/// The ring in which an omnidirectional camera's mirror appears, in an image of one size.
struct MirrorRing {
  cv::Point2d center;  ///< pixels; the centre of the upper left one is (0.5, 0.5)
  double inner = 0;    ///< px, radius
  double outer = 0;    ///< px, radius
};

/// Converts a mirror that is not `none` to the ring in an image of `size`, and back.
MirrorRing ringIn(cv::Size size, const PanoramaOptions& options);
PanoramaOptions optionsOf(const MirrorRing& ring, cv::Size size);

/// Unrolls the ring: each row of the panorama is a circle, with the mirror's rim at the top. It
/// begins and ends below the centre of the image and runs anticlockwise, so that the view is not
/// reversed if the camera looks up into the mirror. The panorama is as high as the ring is wide,
/// and as wide as its middle circle is long, so that pixels keep their size there. Keeps its
/// buffers: use one per thread.
class Panorama {
 public:
  /// The mirror must not be `found` any more.
  explicit Panorama(PanoramaOptions options);

  /// `image` (CV_8UC3 or CV_8UC1) itself if there is no mirror; else its panorama, valid until the
  /// next call. Parts of the ring outside of the image are black.
  const cv::Mat& unrolled(const cv::Mat& image);

 private:
  void follow(cv::Size size);

  PanoramaOptions options_;
  cv::Size size_;  ///< of the images for map_
  cv::Mat map_;    ///< CV_32FC2: position of each pixel in the image
  cv::Mat panorama_;
};

}  // namespace place_recognition
