#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "features/mr8_filter_bank.h"
#include "place_recognition/feature.h"

namespace place_recognition {

/// The eight responses of pixels spread evenly over an image, one pixel per row.
cv::Mat1f sampledPixels(const Mr8FilterBank::Responses& responses, int count);

/// The representation of materials in chapter 7 (Varma and Zisserman 2005): filter responses are
/// clustered within each material, and an image is described by how often each cluster centre, a
/// texton, is the nearest one to a pixel.
class TextonDictionary {
 public:
  static constexpr int kPerMaterial = 10;

  /// `materials`: for each material, responses of pixels of its training images, one pixel per row;
  /// at least one row. Textons are the centres found by k-means, with starting points that depend
  /// on the data only.
  explicit TextonDictionary(const std::vector<cv::Mat1f>& materials);

  /// One row per texton: those of the first material, then those of the next; kPerMaterial of each,
  /// or as many as it has pixels.
  const cv::Mat1f& textons() const { return textons_; }

  /// Percentage of an image's pixels that are nearest to each texton. (With percentages rather than
  /// fractions, gamma and the offset p of a kernel have the same meaning as in Tables 7.1 to 7.5:
  /// the thesis finds a gamma of chi-squared a hundred times smaller for MR8 than for LBP.)
  DenseVector histogram(const Mr8FilterBank::Responses& responses) const;

 private:
  cv::Mat1f textons_;
};

}  // namespace place_recognition
