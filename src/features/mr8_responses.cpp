#include "features/mr8_responses.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/simd.h"
#include "features/grey_levels.h"

namespace place_recognition {

namespace {

constexpr float kWeberContrast = 0.03f;
constexpr float kLeast = 1e-30f;  ///< smallest norm used as a divisor

/// Grey levels. Smaller than the standard deviation of an image with a single deviating pixel;
/// larger than that of a blank image, which rounding errors keep from being zero on some machines.
constexpr double kBlank = 1e-4;

/// Normalizes to zero mean and unit variance; a blank image becomes zero.
void normalize(const cv::Mat& grey, cv::Mat1f& image) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  const double scale = deviation[0] > kBlank ? 1 / deviation[0] : 0;
  grey.convertTo(image, CV_32F, scale, -mean[0] * scale);
}

/// The natural logarithm of x >= 1, to 2e-7: with x = 2^k m and s = (m - 1) / (m + 1), |s| < 0.172,
/// it is k log 2 + 2 (s + s^3 / 3 + s^5 / 5 + ...).
PLACE_RECOGNITION_INLINE float logarithm(float x) {
  constexpr std::int32_t kRootOfHalf = 0x3f3504f3;  // the bits of the least m
  std::int32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const std::int32_t k = (bits - kRootOfHalf) >> 23;
  bits -= k << 23;
  float m;
  std::memcpy(&m, &bits, sizeof m);
  const float s = (m - 1) / (m + 1), square = s * s;
  const float series =
      1 + square * (1.0f / 3 + square * (1.0f / 5 + square * (1.0f / 7 + square * (1.0f / 9))));
  return static_cast<float>(k) * 0.69314718056f + 2 * s * series;
}

/// Scales the responses r of n pixels by log(1 + |r| / 0.03) / |r|.
PLACE_RECOGNITION_TARGET_CLONES
void scaleRow(const std::array<float*, Mr8FilterBank::kResponses>& responses, int n) {
  const std::array<float*, Mr8FilterBank::kResponses> rows = responses;
  PLACE_RECOGNITION_INDEPENDENT
  for (int x = 0; x < n; ++x) {
    float square = 0;
    for (const float* row : rows) square += row[x] * row[x];
    const float norm = std::sqrt(square);
    const float gain = logarithm(1 + norm / kWeberContrast) / std::max(norm, kLeast);
    for (float* row : rows) row[x] *= gain;
  }
}

}  // namespace

const Mr8FilterBank::Responses& Mr8Responses::of(const cv::Mat& image) {
  normalize(greyLevels(image, converted_), normalized_);
  filters_.apply(normalized_, responses_);
  if (weber_) scaleByContrast();
  return responses_;
}

void Mr8Responses::scaleByContrast() {
  for (int y = 0; y < responses_[0].rows; ++y) {
    std::array<float*, Mr8FilterBank::kResponses> rows;
    for (int k = 0; k < Mr8FilterBank::kResponses; ++k) rows[k] = responses_[k][y];
    scaleRow(rows, responses_[0].cols);
  }
}

}  // namespace place_recognition
