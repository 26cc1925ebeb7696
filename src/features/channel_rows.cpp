#include "features/channel_rows.h"

#include <cassert>

#include "base/simd.h"

namespace place_recognition {
namespace {

/// A channel is a combination of B, G and R with these factors, minus the middle of its range.
struct Mixture {
  std::int16_t b, g, r, middle;
};

Mixture mixture(Channel channel) {
  switch (channel) {
    case Channel::kL:
      return {1, 1, 1, 383};
    case Channel::kR:
      return {0, 0, 1, 128};
    case Channel::kG:
      return {0, 1, 0, 128};
    case Channel::kB:
      return {1, 0, 0, 128};
    case Channel::kC1:
      return {0, -1, 1, 0};
    case Channel::kC2:
      return {-2, 1, 1, 0};
  }
  return {};
}

PLACE_RECOGNITION_TARGET_CLONES
void mixColours(const std::uint8_t* __restrict bgr, const Mixture& mixture, int n,
                float* __restrict out) {
  const auto [b, g, r, middle] = mixture;
  for (int x = 0; x < n; ++x) {
    // 16 bits suffice, and a vector holds more of them.
    auto sum = static_cast<std::int16_t>(b * bgr[3 * x]);
    sum = static_cast<std::int16_t>(sum + g * bgr[3 * x + 1]);
    sum = static_cast<std::int16_t>(sum + r * bgr[3 * x + 2]);
    out[x] = static_cast<std::int16_t>(sum - middle);
  }
}

/// Every third number from the first on: the channel of a mixture of only one.
PLACE_RECOGNITION_TARGET_CLONES
void takeColour(const std::uint8_t* __restrict channel, int n, float* __restrict out) {
  for (int x = 0; x < n; ++x) out[x] = static_cast<float>(channel[3 * x] - 128);
}

PLACE_RECOGNITION_TARGET_CLONES
void mixGrey(const std::uint8_t* __restrict grey, const Mixture& mixture, int n,
             float* __restrict out) {
  const int sum = mixture.b + mixture.g + mixture.r;
  for (int x = 0; x < n; ++x) out[x] = static_cast<float>(sum * grey[x] - mixture.middle);
}

}  // namespace

void extractChannelRow(const cv::Mat& image, Channel channel, int y, int left, int n, float* row) {
  assert(left >= 0 && left + n <= image.cols);
  assert(image.type() == CV_8UC3 || image.type() == CV_8UC1);
  const std::uint8_t* pixels = image.ptr<std::uint8_t>(y) + left * image.channels();
  if (image.type() == CV_8UC1) return mixGrey(pixels, mixture(channel), n, row);
  switch (channel) {
    case Channel::kB:
      return takeColour(pixels, n, row);
    case Channel::kG:
      return takeColour(pixels + 1, n, row);
    case Channel::kR:
      return takeColour(pixels + 2, n, row);
    default:
      return mixColours(pixels, mixture(channel), n, row);
  }
}

ChannelScale channelScale(Channel channel) {
  const double middle = mixture(channel).middle;
  switch (channel) {
    case Channel::kL:
      return {1.0 / 3, middle};
    case Channel::kC1:
    case Channel::kC2:
      return {0.5, middle};
    default:
      return {1, middle};
  }
}

}  // namespace place_recognition
