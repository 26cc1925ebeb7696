#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "datasets/image_file.h"
#include "datasets/level_scale.h"

namespace place_recognition {

/// Image files of one camera, converted to 8 bits with one LevelScale. Its range is determined from
/// a few images of the whole sequence when the first image with 16 bits is read.
class ImageSequence {
 public:
  ImageSequence() = default;
  explicit ImageSequence(std::vector<std::string> paths) : paths_(std::move(paths)) {}

  /// Call it before read(); see Recording::setLevelRange().
  void setLevelRange(const LevelRange& range) { scale_ = LevelScale(range); }
  const LevelRange& levelRange() const { return scale_.range(); }

  std::size_t size() const { return paths_.size(); }
  const std::string& path(std::size_t i) const { return paths_[i]; }

  /// Reads image `i` of size(): CV_8UC3 BGR or CV_8UC1, or the reason why there is none.
  DecodedImage read(std::size_t i);

  /// The commonest size of a few images of the whole sequence; 0 x 0 if no image can be decoded.
  cv::Size usualSize();

  /// How images with 16 bits were converted to 8, a sentence; empty if there was none yet.
  std::string note() const;

 private:
  /// The indices of a few images, spread evenly over the sequence.
  std::vector<std::size_t> sample() const;

  std::vector<std::string> paths_;
  LevelScale scale_;
  bool is_deep_ = false;  // an image with 16 bits was read
};

}  // namespace place_recognition
