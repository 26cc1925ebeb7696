#pragma once

#include <string>
#include <vector>

#include "datasets/depth_scale.h"
#include "datasets/image_file.h"

namespace place_recognition {

/// Image files of one camera, brought to 8 bits alike; see DepthScale, which a few of the
/// images from beginning to end set when the first one of 16 bits is read.
class ImageSequence {
 public:
  ImageSequence() = default;
  explicit ImageSequence(std::vector<std::string> paths) : paths_(std::move(paths)) {}

  /// To be called before read(), see Recording::setDepthExtent().
  void setDepthExtent(const DepthExtent& extent) { scale_ = DepthScale(extent); }
  const DepthExtent& depthExtent() const { return scale_.extent(); }

  std::size_t size() const { return paths_.size(); }
  const std::string& path(std::size_t i) const { return paths_[i]; }

  /// Image `i` of size(): CV_8UC3 BGR or CV_8UC1, or why there is none.
  DecodedImage read(std::size_t i);

  /// How images of 16 bits were brought to 8, a sentence; empty if there was none yet.
  std::string note() const;

 private:
  std::vector<std::string> paths_;
  DepthScale scale_;
  bool is_deep_ = false;  // an image of 16 bits was read
};

}  // namespace place_recognition
