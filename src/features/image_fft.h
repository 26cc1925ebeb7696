#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/batched_fft.h"

namespace place_recognition {

/// Computes two-dimensional Fourier transforms of images of one size, kLanes rows or columns at a
/// time. Keeps its buffers: use one per thread.
class ImageFft {
 public:
  using Numbers = BatchedFft::Numbers;
  static constexpr int kLanes = BatchedFft::kLanes;

  /// A spectrum is a sequence of bands of kLanes rows: row fy, column fx is in lane fy % kLanes of
  /// element (fy / kLanes) * width + fx.
  using Spectrum = std::vector<Numbers>;
  /// Writes a band of a spectrum, `width` elements.
  using WriteBand = std::function<void(int band, Numbers* columns)>;
  /// Reads columns `first` to `first` + kLanes - 1 of an image, `height` elements.
  using ReadColumns = std::function<void(int first, const Numbers* rows)>;

  /// For the width and height, see the lengths of BatchedFft.
  explicit ImageFft(cv::Size size);

  cv::Size size() const { return size_; }

  /// spectrum(fy, fx) = sum_yx image(y, x) exp(2 pi i (x fx / width + y fy / height))
  void forward(const cv::Mat1f& image, Spectrum& spectrum);

  /// image(y, x) = sum_fy,fx spectrum(fy, fx) exp(-2 pi i (x fx / width + y fy / height)), for
  /// x < `columns`. After forward(), this is the image times its number of pixels.
  void inverse(const WriteBand& write, int columns, const ReadColumns& read);

 private:
  cv::Size size_;
  int bands_;
  BatchedFft along_rows_, along_columns_;
  std::vector<Numbers> columns_;  ///< of the image, kLanes side by side
  std::vector<Numbers> sequences_, scratch_;
};

}  // namespace place_recognition
