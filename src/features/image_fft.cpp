#include "features/image_fft.h"

#include <algorithm>
#include <cassert>

#include "base/simd.h"

namespace place_recognition {

namespace {

constexpr int kLanes = ImageFft::kLanes;

/// Transposes a matrix of kLanes x kLanes numbers. A number's position consists of four bits for
/// the row and four for the column. A perfect shuffle rotates these bits by one; four shuffles swap
/// row and column.
PLACE_RECOGNITION_INLINE void transpose(float* matrix) {
  static_assert(kLanes == 16, "four bits");
  constexpr int kHalf = kLanes * kLanes / 2;
  float shuffled[2 * kHalf];
  float *from = matrix, *to = shuffled;
  for (int bit = 0; bit < 4; ++bit) {
    PLACE_RECOGNITION_INDEPENDENT
    for (int i = 0; i < kHalf; ++i) {
      to[2 * i] = from[i];
      to[2 * i + 1] = from[kHalf + i];
    }
    std::swap(from, to);
  }
}

/// Moves lane l of in[k] to lane k of out[l], for l < `rows` and k < `columns`.
PLACE_RECOGNITION_TARGET_CLONES
void transpose(const ImageFft::Numbers* in, int columns, ImageFft::Numbers* out, int rows) {
  float real[kLanes * kLanes], imaginary[kLanes * kLanes];
  for (int k = 0; k < columns; ++k) {
    for (int l = 0; l < kLanes; ++l) {
      real[k * kLanes + l] = in[k].real[l];
      imaginary[k * kLanes + l] = in[k].imaginary[l];
    }
  }
  std::fill(real + columns * kLanes, std::end(real), 0.0f);
  std::fill(imaginary + columns * kLanes, std::end(imaginary), 0.0f);
  transpose(real);
  transpose(imaginary);
  for (int l = 0; l < rows; ++l) {
    for (int k = 0; k < kLanes; ++k) {
      out[l].real[k] = real[l * kLanes + k];
      out[l].imaginary[k] = imaginary[l * kLanes + k];
    }
  }
}

/// `out` and `in` may be the same.
void conjugate(const ImageFft::Numbers* in, int count, ImageFft::Numbers* out) {
  for (int i = 0; i < count; ++i) {
    for (int lane = 0; lane < kLanes; ++lane) {
      out[i].real[lane] = in[i].real[lane];
      out[i].imaginary[lane] = -in[i].imaginary[lane];
    }
  }
}

}  // namespace

ImageFft::ImageFft(cv::Size size)
    : size_(size),
      bands_((size.height + kLanes - 1) / kLanes),
      along_rows_(size.width),
      along_columns_(size.height),
      sequences_(std::max(size.width, size.height)),
      scratch_(sequences_.size()) {}

void ImageFft::forward(const cv::Mat1f& image, Spectrum& spectrum) {
  assert(image.size() == size_);
  spectrum.resize(static_cast<std::size_t>(bands_) * size_.width);
  for (int x = 0; x < size_.width; x += kLanes) {
    const int columns = std::min(kLanes, size_.width - x);
    for (int y = 0; y < size_.height; ++y) {
      sequences_[y] = {};
      std::copy_n(image[y] + x, columns, sequences_[y].real);
    }
    const Numbers* rows = along_columns_.transform(sequences_.data(), scratch_.data());
    for (int band = 0; band < bands_; ++band, rows += kLanes) {
      transpose(rows, std::min(kLanes, size_.height - band * kLanes),
                spectrum.data() + band * size_.width + x, columns);
    }
  }
  for (int band = 0; band < bands_; ++band) {
    Numbers* const columns = spectrum.data() + band * size_.width;
    // The image is real, so flipping the sign of the exponent conjugates its spectrum.
    conjugate(along_rows_.transform(columns, scratch_.data()), size_.width, columns);
  }
}

void ImageFft::inverse(const WriteBand& write, int columns, const ReadColumns& read) {
  assert(columns <= size_.width);
  const int height = size_.height;
  columns_.resize(static_cast<std::size_t>(height) * ((columns + kLanes - 1) / kLanes));
  for (int band = 0; band < bands_; ++band) {
    write(band, sequences_.data());
    const Numbers* const row = along_rows_.transform(sequences_.data(), scratch_.data());
    Numbers* out = columns_.data() + band * kLanes;
    for (int x = 0; x < columns; x += kLanes, out += height) {
      transpose(row + x, std::min(kLanes, size_.width - x), out,
                std::min(kLanes, height - band * kLanes));
    }
  }
  Numbers* in = columns_.data();
  for (int x = 0; x < columns; x += kLanes, in += height) {
    read(x, along_columns_.transform(in, scratch_.data()));
  }
}

}  // namespace place_recognition
