#include "datasets/image_sequence.h"

#include <algorithm>

#include "datasets/size_count.h"

namespace place_recognition {

DecodedImage ImageSequence::read(std::size_t i) {
  DecodedImage decoded = readDeepImageFile(paths_[i]);
  if (decoded.image.depth() != CV_16U) return decoded;
  is_deep_ = true;
  if (!scale_.hasSeen()) {
    for (const std::size_t k : sample()) {
      const cv::Mat image = readDeepImageFile(paths_[k]).image;
      if (!image.empty() && image.depth() == CV_16U) scale_.see(levelRangeOf(image));
    }
  }
  decoded.image = scale_.toEightBits(decoded.image);
  return decoded;
}

cv::Size ImageSequence::usualSize() {
  SizeCount sizes;
  for (const std::size_t i : sample()) sizes.add(read(i).image.size(), paths_[i]);
  for (std::size_t i = 0; i < paths_.size() && sizes.usual().empty(); ++i) {
    sizes.add(read(i).image.size(), paths_[i]);
  }
  return sizes.usual();
}

std::vector<std::size_t> ImageSequence::sample() const {
  constexpr std::size_t kMost = 16;
  const std::size_t count = std::min(kMost, paths_.size());
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < count; ++k) indices.push_back(k * paths_.size() / count);
  return indices;
}

std::string ImageSequence::note() const {
  return is_deep_ ? "images with 16 bits are converted to 8: " + scale_.text() + "." : "";
}

}  // namespace place_recognition
