#include "recognition/frames/panorama.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace place_recognition {
namespace {

int shorterSide(cv::Size size) { return std::min(size.width, size.height); }

cv::Size panoramaSize(const MirrorRing& ring) {
  const auto pixels = [](double length) { return std::max(1, static_cast<int>(length + 0.5)); };
  return {pixels(CV_PI * (ring.inner + ring.outer)), pixels(ring.outer - ring.inner)};
}

}  // namespace

MirrorRing ringIn(cv::Size size, const PanoramaOptions& options) {
  const int side = shorterSide(size);
  return {{options.center_x * size.width, options.center_y * size.height},
          options.inner * side,
          options.outer * side};
}

PanoramaOptions optionsOf(const MirrorRing& ring, cv::Size size) {
  const int side = shorterSide(size);
  PanoramaOptions options;
  options.mirror = "given";
  options.center_x = ring.center.x / size.width;
  options.center_y = ring.center.y / size.height;
  options.inner = ring.inner / side;
  options.outer = ring.outer / side;
  return options;
}

Panorama::Panorama(PanoramaOptions options) : options_(std::move(options)) {
  assert(options_.mirror != "found");
}

const cv::Mat& Panorama::unrolled(const cv::Mat& image) {
  if (options_.mirror == "none") return image;
  if (image.size() != size_) follow(image.size());
  cv::remap(image, panorama_, map_, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return panorama_;
}

void Panorama::follow(cv::Size size) {
  size_ = size;
  const MirrorRing ring = ringIn(size, options_);
  const cv::Size panorama = panoramaSize(ring);
  map_.create(panorama, CV_32FC2);
  for (int x = 0; x < panorama.width; ++x) {
    const double angle = 2 * CV_PI * (x + 0.5) / panorama.width;  // anticlockwise, from below
    for (int y = 0; y < panorama.height; ++y) {
      const double radius = ring.outer - (y + 0.5) * (ring.outer - ring.inner) / panorama.height;
      const cv::Point2d at = ring.center + radius * cv::Point2d(std::sin(angle), std::cos(angle));
      map_.at<cv::Vec2f>(y, x) =
          cv::Vec2f(static_cast<float>(at.x - 0.5), static_cast<float>(at.y - 0.5));
    }
  }
}

}  // namespace place_recognition
