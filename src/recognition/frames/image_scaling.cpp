#include "recognition/frames/image_scaling.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace place_recognition {
namespace {

cv::Size times(cv::Size size, double factor) {
  const auto side = [factor](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels * factor)));
  };
  return {side(size.width), side(size.height)};
}

cv::Size narrowed(cv::Size size, int max_width) {
  if (max_width == 0 || size.width <= max_width) return size;
  return times(size, static_cast<double>(max_width) / size.width);
}

int longerSide(cv::Size size) { return std::max(size.width, size.height); }

/// Fast, and slightly smoother than an image taken by a camera of that size; suitable if the
/// training images are scaled down in the same way.
void scaleDown(const cv::Mat& image, cv::Size size, cv::Mat& result) {
  const bool by_half = image.cols >= 2 * size.width;
  cv::resize(image, result, size, 0, 0, by_half ? cv::INTER_AREA : cv::INTER_LINEAR);
}

/// Averages over the areas of the new pixels.
void shrink(const cv::Mat& image, cv::Size size, cv::Mat& result) {
  // Borders of new pixels that cut old ones have a blurring effect, which is noticeable if the new
  // pixels are only slightly larger. Therefore enlarge the image first.
  const bool cuts = size.width * (image.cols / size.width) != image.cols;
  const bool shows = image.cols < 2 * size.width;
  cv::resize(cuts && shows ? enlarged(image, size * 2) : image, result, size, 0, 0, cv::INTER_AREA);
}

}  // namespace

const cv::Mat& scaledDown(const cv::Mat& image, int max_width, cv::Mat& buffer) {
  const cv::Size size = narrowed(image.size(), max_width);
  if (size == image.size()) return image;
  shrink(image, size, buffer);
  return buffer;
}

cv::Mat enlarged(const cv::Mat& image, cv::Size size) {
  // The inverse of the filter whose taps are the means, over a pixel's area, of the Lanczos kernels
  // of that pixel and its neighbours.
  static const cv::Matx<float, 9, 1> kFromMeansToCentres(0.00783646f, -0.02101427f, 0.04351784f,
                                                         -0.11903913f, 1.1773982f, -0.11903913f,
                                                         0.04351784f, -0.02101427f, 0.00783646f);
  cv::Mat centres, large, result;
  cv::sepFilter2D(image, centres, CV_32F, kFromMeansToCentres, kFromMeansToCentres, {-1, -1}, 0,
                  cv::BORDER_REFLECT | cv::BORDER_ISOLATED);
  cv::resize(centres, large, size, 0, 0, cv::INTER_LANCZOS4);
  large.convertTo(result, image.type());
  return result;
}

ImageScaler::ImageScaler(const ImageProfile& trained, int max_width)
    : max_width_(max_width),
      trained_(narrowed({trained.width, trained.height}, max_width)),
      trained_on_scaled_(trained.width == 0 || trained.width != trained_.width) {}

cv::Size ImageScaler::sizeFor(cv::Size size) const {
  if (trained_.empty()) return narrowed(size, max_width_);
  const double factor = static_cast<double>(longerSide(trained_)) / longerSide(size);
  return times(size, std::min(factor, kMaxEnlargement));
}

const cv::Mat& ImageScaler::scaled(const cv::Mat& image) {
  const cv::Size size = sizeFor(image.size());
  if (size == image.size()) return image;
  if (size.width >= image.cols && size.height >= image.rows) {
    buffer_ = enlarged(image, size);
  } else if (trained_on_scaled_) {
    scaleDown(image, size, buffer_);
  } else {
    shrink(image, size, buffer_);
  }
  return buffer_;
}

}  // namespace place_recognition
