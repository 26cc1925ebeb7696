#include "datasets/image_sequence.h"

#include <algorithm>

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

std::string ImageSequence::note() const {
  return is_deep_ ? "images with 16 bits are converted to 8: " + scale_.text() + "." : "";
}

}  // namespace place_recognition
