#include "features/edge_density.h"

#include <opencv2/imgproc.hpp>

#include "features/grey_levels.h"

namespace place_recognition {

double EdgeDensity::of(const cv::Mat& image) {
  constexpr int kSobelGain = 8;  // response to a ramp of one grey level per pixel
  constexpr int kLeast = 4 * kSobelGain;
  cv::GaussianBlur(greyLevels(image, converted_), smoothed_, cv::Size(), 1, 1,
                   cv::BORDER_DEFAULT | cv::BORDER_ISOLATED);
  cv::spatialGradient(smoothed_, x_, y_);
  std::size_t edges = 0;
  for (int row = 0; row < x_.rows; ++row) {
    const short* const x = x_.ptr<short>(row);
    const short* const y = y_.ptr<short>(row);
    for (int i = 0; i < x_.cols; ++i) edges += x[i] * x[i] + y[i] * y[i] > kLeast * kLeast ? 1 : 0;
  }
  return static_cast<double>(edges) / static_cast<double>(x_.total());
}

}  // namespace place_recognition
