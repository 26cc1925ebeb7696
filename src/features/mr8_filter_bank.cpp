#include "features/mr8_filter_bank.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/simd.h"

namespace place_recognition {

namespace {

using Numbers = ImageFft::Numbers;

constexpr int kLanes = ImageFft::kLanes;
constexpr int kHalf = Mr8FilterBank::kSupport / 2;
constexpr int kTile = 320;  // pixels, at most; a tile's spectrum fits in the L2 cache
constexpr double kElongation = 3;
constexpr double kIsotropicSigma = 10;

double gauss(double x, double sigma) { return std::exp(-x * x / (2 * sigma * sigma)); }

/// Samples `function(x, y)` on the filter's grid, subtracts the mean if `zero_mean`, and scales to
/// L1 norm one.
template <typename Function>
cv::Mat1f makeFilter(bool zero_mean, const Function& function) {
  cv::Mat1d filter(Mr8FilterBank::kSupport, Mr8FilterBank::kSupport);
  for (int y = -kHalf; y <= kHalf; ++y) {
    for (int x = -kHalf; x <= kHalf; ++x) filter(y + kHalf, x + kHalf) = function(x, y);
  }
  if (zero_mean) filter -= cv::mean(filter)[0];
  return cv::Mat1f(filter / cv::norm(filter, cv::NORM_L1));
}

/// A function of the coordinates along and across the filter's long axis.
template <typename Function>
cv::Mat1f makeOrientedFilter(int orientation, const Function& function) {
  const double angle = CV_PI * orientation / Mr8FilterBank::kOrientations;
  const double c = std::cos(angle), s = std::sin(angle);
  return makeFilter(true, [&](int x, int y) { return function(c * x + s * y, c * y - s * x); });
}

/// out = factors * in
PLACE_RECOGNITION_TARGET_CLONES
void multiply(const Numbers* __restrict in, const float* __restrict factors, int count,
              Numbers* __restrict out) {
  for (int i = 0; i < count; ++i, factors += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      out[i].real[lane] = factors[lane] * in[i].real[lane];
      out[i].imaginary[lane] = factors[lane] * in[i].imaginary[lane];
    }
  }
}

/// out = (real + i imaginary) * in
PLACE_RECOGNITION_TARGET_CLONES
void multiply(const Numbers* __restrict in, const float* __restrict real,
              const float* __restrict imaginary, int count, Numbers* __restrict out) {
  for (int i = 0; i < count; ++i, real += kLanes, imaginary += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const float a = in[i].real[lane], b = in[i].imaginary[lane];
      out[i].real[lane] = real[lane] * a - imaginary[lane] * b;
      out[i].imaginary[lane] = real[lane] * b + imaginary[lane] * a;
    }
  }
}

/// largest = max(largest, |in|), part by part; or = |in| if `first`.
PLACE_RECOGNITION_TARGET_CLONES
void keepLarger(const Numbers* __restrict in, int count, bool first, Numbers* __restrict largest) {
  const auto larger = [first](float a, float b) { return !first && a > b ? a : b; };
  for (int i = 0; i < count; ++i) {
    for (int lane = 0; lane < kLanes; ++lane) {
      largest[i].real[lane] = larger(largest[i].real[lane], std::fabs(in[i].real[lane]));
      largest[i].imaginary[lane] =
          larger(largest[i].imaginary[lane], std::fabs(in[i].imaginary[lane]));
    }
  }
}

/// The length of the equal parts, at most kTile long, into which `length` is divided.
int tileLength(int length) {
  const int tiles = (length + kTile - 1) / kTile;
  return (length + tiles - 1) / tiles;
}

}  // namespace

cv::Mat1f Mr8FilterBank::edge(int scale, int orientation) {
  const double sigma = 1 << scale;
  return makeOrientedFilter(orientation, [sigma](double along, double across) {
    return gauss(along, kElongation * sigma) * -across * gauss(across, sigma);
  });
}

cv::Mat1f Mr8FilterBank::bar(int scale, int orientation) {
  const double sigma = 1 << scale;
  return makeOrientedFilter(orientation, [sigma](double along, double across) {
    return gauss(along, kElongation * sigma) * (across * across / (sigma * sigma) - 1) *
           gauss(across, sigma);
  });
}

cv::Mat1f Mr8FilterBank::gaussian() {
  return makeFilter(false, [](int x, int y) { return gauss(std::hypot(x, y), kIsotropicSigma); });
}

cv::Mat1f Mr8FilterBank::laplacian() {
  return makeFilter(true, [](int x, int y) {
    const double r = std::hypot(x, y) / kIsotropicSigma;
    return (r * r - 2) * gauss(r, 1);
  });
}

void Mr8FilterBank::apply(const cv::Mat1f& image, Responses& responses) {
  for (cv::Mat1f& response : responses) response.create(image.size());
  const cv::Size size(tileLength(image.cols), tileLength(image.rows));
  prepare(size);
  for (int y = 0; y < image.rows; y += size.height) {
    for (int x = 0; x < image.cols; x += size.width) {
      const cv::Rect tile = cv::Rect({x, y}, size) & cv::Rect({}, image.size());
      pad(image, tile);
      fft_->forward(padded_, spectrum_);
      filterTile(tile, responses);
    }
  }
}

void Mr8FilterBank::prepare(cv::Size tile) {
  const cv::Size size(BatchedFft::lengthFrom(tile.width + 2 * kHalf),
                      BatchedFft::lengthFrom(tile.height + 2 * kHalf));
  if (fft_ && fft_->size() == size) return;
  fft_.emplace(size);
  bar_and_edge_.clear();
  for (int scale = 0; scale < kScales; ++scale) {
    for (int orientation = 0; orientation < kOrientations; ++orientation) {
      Plane sum = spectrumOf(bar(scale, orientation), &Numbers::real);
      const Plane odd = spectrumOf(edge(scale, orientation), &Numbers::imaginary);
      std::transform(sum.begin(), sum.end(), odd.begin(), sum.begin(), std::minus<float>());
      bar_and_edge_.push_back(std::move(sum));
    }
  }
  gaussian_ = spectrumOf(gaussian(), &Numbers::real);
  laplacian_ = spectrumOf(laplacian(), &Numbers::real);
}

Mr8FilterBank::Plane Mr8FilterBank::spectrumOf(const cv::Mat1f& filter,
                                               float (Numbers::*part)[kLanes]) {
  const cv::Size size = fft_->size();
  padded_.create(size);
  padded_ = 0;
  for (int y = -kHalf; y <= kHalf; ++y) {
    for (int x = -kHalf; x <= kHalf; ++x) {
      padded_((y + size.height) % size.height, (x + size.width) % size.width) =
          filter(y + kHalf, x + kHalf);
    }
  }
  fft_->forward(padded_, spectrum_);
  const float pixels = static_cast<float>(size.area());
  Plane plane;
  for (const Numbers& numbers : spectrum_) {
    for (const float number : numbers.*part) plane.push_back(number / pixels);
  }
  return plane;
}

void Mr8FilterBank::pad(const cv::Mat1f& image, cv::Rect tile) {
  // The margin before the tile wraps around to the end of the period.
  const auto source = [](int at, int period, int first, int length) {
    return cv::borderInterpolate(first + (at < period - kHalf ? at : at - period), length,
                                 cv::BORDER_REFLECT_101);
  };
  const cv::Size size = fft_->size();
  std::vector<int> columns;
  for (int x = 0; x < size.width; ++x) {
    columns.push_back(source(x, size.width, tile.x, image.cols));
  }
  padded_.create(size);
  for (int y = 0; y < size.height; ++y) {
    const float* const in = image[source(y, size.height, tile.y, image.rows)];
    float* const out = padded_[y];
    for (int x = 0; x < size.width; ++x) out[x] = in[columns[x]];
  }
}

void Mr8FilterBank::filterTile(cv::Rect tile, Responses& responses) {
  const int width = fft_->size().width;
  pairs_.resize((tile.width + kLanes - 1) / kLanes * tile.height);
  for (int scale = 0; scale < kScales; ++scale) {
    for (int orientation = 0; orientation < kOrientations; ++orientation) {
      const float* const factors = bar_and_edge_[scale * kOrientations + orientation].data();
      fft_->inverse(
          [&](int band, Numbers* columns) {
            const int first = band * width;
            multiply(spectrum_.data() + first, factors + kLanes * first, width, columns);
          },
          tile.width,
          [&](int x, const Numbers* rows) {
            keepLarger(rows, tile.height, orientation == 0, pairs(x, tile));
          });
    }
    takePairs(tile, responses[kScales + scale], responses[scale]);
  }
  fft_->inverse(
      [&](int band, Numbers* columns) {
        const int first = band * width;
        multiply(spectrum_.data() + first, gaussian_.data() + kLanes * first,
                 laplacian_.data() + kLanes * first, width, columns);
      },
      tile.width,
      [&](int x, const Numbers* rows) { std::copy_n(rows, tile.height, pairs(x, tile)); });
  takePairs(tile, responses[2 * kScales], responses[2 * kScales + 1]);
}

Numbers* Mr8FilterBank::pairs(int x, cv::Rect tile) {
  return pairs_.data() + x / kLanes * tile.height;
}

void Mr8FilterBank::takePairs(cv::Rect tile, cv::Mat1f& real, cv::Mat1f& imaginary) {
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; x += kLanes) {
      const Numbers& numbers = pairs(x, tile)[y];
      const int count = std::min(kLanes, tile.width - x);
      std::copy_n(numbers.real, count, &real(tile.y + y, tile.x + x));
      std::copy_n(numbers.imaginary, count, &imaginary(tile.y + y, tile.x + x));
    }
  }
}

}  // namespace place_recognition
