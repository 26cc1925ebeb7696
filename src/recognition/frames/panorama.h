#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "place_recognition/training_options.h"

namespace place_recognition {

/// The ring that the mirror of an omnidirectional camera shows in an image of one size.
struct MirrorRing {
  cv::Point2d center;  ///< pixels; the centre of the upper left one is (0.5, 0.5)
  double inner = 0;    ///< px, radius
  double outer = 0;    ///< px, radius
};

/// That of a mirror which is not `none`, in an image of `size`; and the other way round.
MirrorRing ringIn(cv::Size size, const PanoramaOptions& options);
PanoramaOptions optionsOf(const MirrorRing& ring, cv::Size size);

/// Unrolls the ring: a row of the panorama is a circle, the mirror's rim at the top; it begins and
/// ends below the centre of the image, and goes anticlockwise, which shows nothing mirrored if the
/// camera looks up into the mirror. As high as the ring is wide and as wide as its middle circle is
/// long, so that there a pixel is one still. Keeps its buffers: one per thread.
class Panorama {
 public:
  /// A mirror that is still to be `found` is a broken precondition.
  explicit Panorama(PanoramaOptions options);

  /// `image` (CV_8UC3 or CV_8UC1) itself without a mirror; else its panorama, which stays valid
  /// until the next call. What lies beside the image is black.
  const cv::Mat& unrolled(const cv::Mat& image);

 private:
  void follow(cv::Size size);

  PanoramaOptions options_;
  cv::Size size_;  ///< of the images that map_ is for
  cv::Mat map_;    ///< CV_32FC2: where in the image a pixel is seen
  cv::Mat panorama_;
};

}  // namespace place_recognition
