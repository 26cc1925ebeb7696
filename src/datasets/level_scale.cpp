#include "datasets/level_scale.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "place_recognition/level_range.h"

namespace place_recognition {
namespace {

constexpr std::uint32_t kLevels = 1 << 16;

/// The smallest power of two greater than `value`, at least 256.
std::uint32_t powerAbove(std::uint32_t value) {
  std::uint32_t power = 256;
  while (power <= value) power *= 2;
  return power;
}

}  // namespace

LevelRange levelRangeOf(const cv::Mat& image) {
  assert(image.depth() == CV_16U && !image.empty());
  const cv::Mat channels = image.reshape(1);
  std::vector<std::size_t> counts(kLevels);
  for (int row = 0; row < channels.rows; ++row) {
    const auto* values = channels.ptr<std::uint16_t>(row);
    for (int col = 0; col < channels.cols; ++col) ++counts[values[col]];
  }
  const std::size_t ignored = channels.total() / 200;
  std::uint32_t low = 0, high = kLevels - 1;
  for (std::size_t below = counts[low]; below <= ignored; below += counts[low]) ++low;
  for (std::size_t above = counts[high]; above <= ignored; above += counts[high]) --high;
  return {low, high};
}

LevelScale::LevelScale(const LevelRange& range) : range_(range), given_(range.known()) {
  if (given_) setWindow();
}

void LevelScale::see(const LevelRange& range) {
  if (given_) return;
  range_ = united(range_, range);
  setWindow();
}

void LevelScale::setWindow() {
  const auto [low, high] = range_;
  if (low < high / 2 || high == 0) {
    start_ = 0;
    width_ = powerAbove(high);
    return;
  }
  // A thermal camera: far from zero. Half of the window is reserved for later images.
  width_ = powerAbove(2 * (high - low));
  const std::uint32_t step = width_ / 4;
  start_ = low / step * step;
  if (start_ >= step) start_ -= step;
}

cv::Mat LevelScale::toEightBits(const cv::Mat& image) {
  if (image.depth() != CV_16U) return image;
  if (!given_) see(levelRangeOf(image));
  cv::Mat scaled(image.size(), CV_8UC(image.channels()));
  const cv::Mat from = image.reshape(1);
  cv::Mat to = scaled.reshape(1);
  for (int row = 0; row < from.rows; ++row) {
    const auto* values = from.ptr<std::uint16_t>(row);
    auto* bytes = to.ptr<std::uint8_t>(row);
    for (int col = 0; col < from.cols; ++col) {
      const std::uint32_t above = values[col] > start_ ? values[col] - start_ : 0;
      bytes[col] = static_cast<std::uint8_t>(std::min(above * 256 / width_, std::uint32_t{255}));
    }
  }
  return scaled;
}

std::string LevelScale::text() const {
  return std::to_string(start_) + " .. " + std::to_string(std::min(start_ + width_, kLevels) - 1) +
         " of 16 bits" + (given_ ? ", as in training" : "");
}

}  // namespace place_recognition
