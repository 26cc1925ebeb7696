#include "simulation/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace place_recognition::simulation {
namespace {

constexpr float kVignetting = 0.22f;   ///< light lost in the corners
constexpr float kTarget = 0.2f;        ///< mean exposure targeted by the meter; 1 is white
constexpr float kMeterCeiling = 1.0f;  ///< the meter clips at this brightness
constexpr float kCorrection = 0.55f;   ///< fraction of a colour cast that is removed
constexpr float kFullWell = 9000.0f;   ///< electrons at white, at the lowest sensitivity
constexpr float kReadNoise = 14.0f;    ///< electrons
constexpr float kBrightEnough = 1.2f;  ///< mean radiance below which the sensitivity rises
constexpr float kMaxGain = 4.0f;

/// The weight of a pixel for the meter, and the light that reaches it.
float squaredRadius(cv::Size size, int x, int y) {
  const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width) - 0.5f;
  const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height) - 0.5f;
  return 2.0f * (u * u + v * v);
}

float luminance(const Vec3& bgr) { return 0.07f * bgr[0] + 0.72f * bgr[1] + 0.21f * bgr[2]; }

/// The factor that brings the metered mean of exposed luminances to the target.
float exposure(const cv::Mat& radiance) {
  std::vector<std::array<float, 2>> samples;  // luminance, weight
  float total = 0.0f;
  for (int y = 0; y < radiance.rows; y += 4) {
    for (int x = 0; x < radiance.cols; x += 4) {
      const float weight = 1.5f - squaredRadius(radiance.size(), x, y);
      samples.push_back({luminance(radiance.at<Vec3>(y, x)), weight});
      total += weight;
    }
  }
  float low = 1e-4f, high = 1e3f;
  for (int step = 0; step < 30; ++step) {
    const float factor = std::sqrt(low * high);
    float sum = 0.0f;
    for (const auto& [value, weight] : samples) {
      sum += weight * std::min(factor * value, kMeterCeiling);
    }
    (sum < kTarget * total ? low : high) = factor;
  }
  return std::sqrt(low * high);
}

/// Gains that remove part of the image's mean colour; overexposed parts are ignored.
Vec3 whiteBalance(const cv::Mat& radiance, float factor) {
  Vec3 mean(1e-6f, 1e-6f, 1e-6f);
  for (int y = 0; y < radiance.rows; y += 4) {
    for (int x = 0; x < radiance.cols; x += 4) {
      const Vec3& pixel = radiance.at<Vec3>(y, x);
      if (factor * luminance(pixel) < 0.9f) mean += pixel;
    }
  }
  Vec3 gain;
  for (int c = 0; c < 3; ++c) gain[c] = std::pow(mean[1] / mean[c], kCorrection);
  return gain;
}

/// Linear 0..4 to 0..255: the sRGB curve, bent before it reaches white.
const std::array<uchar, 4096>& toneCurve() {
  static const std::array<uchar, 4096> kCurve = [] {
    std::array<uchar, 4096> curve{};
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const float linear = static_cast<float>(i) / 1023.75f;
      const float bent = 1.0f - std::exp(-1.25f * linear - 0.5f * linear * linear);
      const float srgb =
          bent <= 0.0031308f ? 12.92f * bent : 1.055f * std::pow(bent, 1.0f / 2.4f) - 0.055f;
      curve[i] = cv::saturate_cast<uchar>(255.0f * srgb);
    }
    return curve;
  }();
  return kCurve;
}

/// A fixed table of normal deviates: drawing them one by one would take longer than rendering.
const std::array<float, 8192>& deviates() {
  static const std::array<float, 8192> kDeviates = [] {
    std::array<float, 8192> values{};
    Random random(5);
    for (float& value : values) value = random.normal();
    return values;
  }();
  return kDeviates;
}

}  // namespace

View turned(View view, float angle) {
  view.yaw += angle;
  view.pitch *= std::cos(angle);
  return view;
}

float focalLength(int width) { return 6.5f / 7.18f * static_cast<float>(width); }

cv::Mat develop(const cv::Mat& radiance, Random random) {
  const float factor = exposure(radiance);
  const Vec3 gain = factor * whiteBalance(radiance, factor);
  // The exposure time is limited: in the dark, fewer electrons must suffice.
  const float sensitivity = std::clamp(factor * kBrightEnough / kTarget, 1.0f, kMaxGain);
  const float full = kFullWell / sensitivity;
  const float read = kReadNoise * kReadNoise;
  const auto& curve = toneCurve();
  const auto& normal = deviates();

  cv::Mat image(radiance.size(), CV_8UC3);
  for (int y = 0; y < radiance.rows; ++y) {
    for (int x = 0; x < radiance.cols; ++x) {
      const float light = 1.0f - kVignetting * squaredRadius(radiance.size(), x, y);
      const Vec3& in = radiance.at<Vec3>(y, x);
      std::uint64_t bits = random.next();
      for (int c = 0; c < 3; ++c, bits >>= 13) {
        const float exposed = std::min(light * gain[c] * in[c], 4.0f);
        const float deviation = std::sqrt(exposed * full + read) / full;
        const float value = exposed + deviation * normal[bits & 8191];
        const float entry = std::clamp(value * 1023.75f + 0.5f, 0.0f, 4095.0f);
        image.at<cv::Vec3b>(y, x)[c] = curve[static_cast<std::size_t>(entry)];
      }
    }
  }
  return image;
}

}  // namespace place_recognition::simulation
