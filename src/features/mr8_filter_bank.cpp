#include "features/mr8_filter_bank.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"

namespace place_recognition {

namespace {

constexpr int kHalf = Mr8FilterBank::kSupport / 2;
constexpr double kElongation = 3;
constexpr double kIsotropicSigma = 10;

double gauss(double x, double sigma) { return std::exp(-x * x / (2 * sigma * sigma)); }

/// Samples `function(x, y)` on the filter's grid; takes off the mean if `zero_mean`; L1 norm one.
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

/// The spectrum of a filter whose centre is at the origin.
cv::Mat2f spectrumOf(const cv::Mat1f& filter, cv::Size size) {
  cv::Mat1f around_origin(size, 0.0f);
  for (int y = -kHalf; y <= kHalf; ++y) {
    for (int x = -kHalf; x <= kHalf; ++x) {
      around_origin((y + size.height) % size.height, (x + size.width) % size.width) =
          filter(y + kHalf, x + kHalf);
    }
  }
  cv::Mat2f spectrum;
  cv::dft(around_origin, spectrum, cv::DFT_COMPLEX_OUTPUT);
  return spectrum;
}

cv::Mat1f part(const cv::Mat2f& spectrum, int which) {
  cv::Mat1f plane;
  cv::extractChannel(spectrum, plane, which);
  return plane;
}

/// out = (real + i imaginary) in, element by element.
PLACE_RECOGNITION_TARGET_CLONES
void multiply(const float* in, const float* real, const float* imaginary, int count,
              float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    out[2 * i] = real[i] * in[2 * i] - imaginary[i] * in[2 * i + 1];
    out[2 * i + 1] = real[i] * in[2 * i + 1] + imaginary[i] * in[2 * i];
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void multiplyImaginary(const float* in, const float* imaginary, int count, float* __restrict out) {
  for (int i = 0; i < count; ++i) {
    out[2 * i] = -imaginary[i] * in[2 * i + 1];
    out[2 * i + 1] = imaginary[i] * in[2 * i];
  }
}

PLACE_RECOGNITION_TARGET_CLONES
void keepLarger(const float* pairs, int count, float* __restrict first, float* __restrict second) {
  for (int i = 0; i < count; ++i) {
    first[i] = std::max(first[i], std::fabs(pairs[2 * i]));
    second[i] = std::max(second[i], std::fabs(pairs[2 * i + 1]));
  }
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

void Mr8FilterBank::prepare(cv::Size size) {
  if (gaussian_spectrum_.size() == size) return;
  edge_and_bar_.clear();
  for (int scale = 0; scale < kScales; ++scale) {
    for (int orientation = 0; orientation < kOrientations; ++orientation) {
      const cv::Mat1f odd = part(spectrumOf(edge(scale, orientation), size), 1);
      const cv::Mat1f even = part(spectrumOf(bar(scale, orientation), size), 0);
      edge_and_bar_.push_back(odd + even);
    }
  }
  gaussian_spectrum_ = part(spectrumOf(gaussian(), size), 0);
  laplacian_spectrum_ = part(spectrumOf(laplacian(), size), 0);
}

void Mr8FilterBank::apply(const cv::Mat1f& image, Responses& responses) {
  const cv::Size size(cv::getOptimalDFTSize(image.cols + 2 * kHalf),
                      cv::getOptimalDFTSize(image.rows + 2 * kHalf));
  prepare(size);
  cv::copyMakeBorder(image, padded_, kHalf, size.height - image.rows - kHalf, kHalf,
                     size.width - image.cols - kHalf, cv::BORDER_REFLECT_101);
  cv::dft(padded_, spectrum_, cv::DFT_COMPLEX_OUTPUT);
  filtered_.create(size);
  const auto inverse = [this] { cv::dft(filtered_, filtered_, cv::DFT_INVERSE | cv::DFT_SCALE); };

  for (cv::Mat1f& response : responses) response = cv::Mat1f::zeros(image.size());
  const cv::Rect inside(cv::Point(kHalf, kHalf), image.size());
  for (std::size_t i = 0; i < edge_and_bar_.size(); ++i) {
    for (int y = 0; y < size.height; ++y) {
      multiplyImaginary(spectrum_.ptr<float>(y), edge_and_bar_[i][y], size.width,
                        filtered_.ptr<float>(y));
    }
    inverse();
    const std::size_t scale = i / kOrientations;
    for (int y = 0; y < image.rows; ++y) {
      keepLarger(filtered_.ptr<float>(y + kHalf, kHalf), image.cols, responses[scale][y],
                 responses[kScales + scale][y]);
    }
  }
  for (int y = 0; y < size.height; ++y) {
    multiply(spectrum_.ptr<float>(y), gaussian_spectrum_[y], laplacian_spectrum_[y], size.width,
             filtered_.ptr<float>(y));
  }
  inverse();
  cv::extractChannel(filtered_(inside), responses[2 * kScales], 0);
  cv::extractChannel(filtered_(inside), responses[2 * kScales + 1], 1);
}

}  // namespace place_recognition
