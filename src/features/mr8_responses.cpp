#include "features/mr8_responses.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace place_recognition {

namespace {

constexpr float kWeberContrast = 0.03f;

/// Below the deviation of grey levels that are all the same but one, in grey levels; above the
/// rounding errors of that of a blank image, which is not zero on every machine.
constexpr double kBlank = 1e-4;

/// Zero mean and unit variance; a blank image becomes zero.
void normalize(const cv::Mat& grey, cv::Mat1f& image) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  const double scale = deviation[0] > kBlank ? 1 / deviation[0] : 0;
  grey.convertTo(image, CV_32F, scale, -mean[0] * scale);
}

/// Scales the responses r of each pixel of a row by log(1 + |r| / 0.03) / |r|.
void scaleByContrast(Mr8FilterBank::Responses& responses, int y) {
  std::array<float*, Mr8FilterBank::kResponses> rows;
  for (int k = 0; k < Mr8FilterBank::kResponses; ++k) rows[k] = responses[k][y];
  for (int x = 0; x < responses[0].cols; ++x) {
    float square = 0;
    for (const float* row : rows) square += row[x] * row[x];
    const float norm = std::sqrt(square);
    if (!(norm > 0)) continue;
    const float gain = std::log1p(norm / kWeberContrast) / norm;
    for (float* row : rows) row[x] *= gain;
  }
}

}  // namespace

const Mr8FilterBank::Responses& Mr8Responses::of(const cv::Mat& image) {
  if (image.channels() == 3) {
    cv::cvtColor(image, grey_, cv::COLOR_BGR2GRAY);
  } else {
    grey_ = image;
  }
  normalize(grey_, normalized_);
  filters_.apply(normalized_, responses_);
  for (int y = 0; weber_ && y < image.rows; ++y) scaleByContrast(responses_, y);
  return responses_;
}

}  // namespace place_recognition
