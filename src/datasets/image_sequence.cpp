#include "datasets/image_sequence.h"

#include <algorithm>
#include <map>
#include <utility>

namespace place_recognition {

DecodedImage ImageSequence::read(std::size_t i) {
  DecodedImage decoded = readDeepImageFile(paths_[i]);
  if (decoded.image.depth() != CV_16U) return decoded;
  is_deep_ = true;
  if (!scale_.hasSeen()) {
    constexpr std::size_t kSamples = 16;
    for (std::size_t k = 0; k < std::min(kSamples, paths_.size()); ++k) {
      const cv::Mat sample =
          readDeepImageFile(paths_[k * paths_.size() / std::min(kSamples, paths_.size())]).image;
      if (!sample.empty() && sample.depth() == CV_16U) scale_.see(depthExtentOf(sample));
    }
  }
  decoded.image = scale_.toEightBits(decoded.image);
  return decoded;
}

cv::Size ImageSequence::usualSize() {
  std::vector<cv::Size> sizes;
  std::map<std::pair<int, int>, int> counts;
  for (const std::string& path : paths_) {
    sizes.push_back(declaredSize(path));
    ++counts[{sizes.back().width, sizes.back().height}];
  }
  const auto countOf = [&](std::size_t i) { return counts.at({sizes[i].width, sizes[i].height}); };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (!sizes[i].empty()) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return countOf(a) > countOf(b); });
  for (const std::size_t i : order) {
    const cv::Mat image = read(i).image;
    if (!image.empty()) return image.size();
  }
  return {};
}

std::string ImageSequence::note() const {
  return is_deep_ ? "images with 16 bits are converted to 8: " + scale_.text() + "." : "";
}

}  // namespace place_recognition
