#include "features/mr8.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "place_recognition/error.h"

namespace place_recognition {

namespace {

constexpr float kWeberContrast = 0.03f;
constexpr int kSigned = 2 * Mr8FilterBank::kScales;  ///< the first response that may be negative

/// Zero mean and unit variance, against brightness and contrast; a blank image becomes zero.
void normalize(const cv::Mat& grey, cv::Mat1f& image) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  const double scale = deviation[0] > 0 ? 1 / deviation[0] : 0;
  grey.convertTo(image, CV_32F, scale, -mean[0] * scale);
}

}  // namespace

void Mr8Options::check() const {
  if (bins < 2 || bins > 200) {
    throw Error("MR8 option 'bins' is " + std::to_string(bins) + "; give a number from 2 to 200.");
  }
  if (!(range > 0 && std::isfinite(range))) throw Error("MR8 option 'range' must be positive.");
}

Mr8Extractor::Mr8Extractor(const Mr8Options& options) : options_(options) { options_.check(); }

void Mr8Extractor::extract(const cv::Mat& image, Feature& feature) {
  if (image.channels() == 3) {
    cv::cvtColor(image, grey_, cv::COLOR_BGR2GRAY);
  } else {
    grey_ = image;
  }
  normalize(grey_, image_);
  filters_.apply(image_, responses_);
  bins_.resize(image.cols);
  counter_.clear();
  for (int y = 0; y < image.rows; ++y) {
    countRow(y);
    counter_.add(bins_.data(), bins_.size());
  }
  if (!std::holds_alternative<SparseVector>(feature)) feature = SparseVector();
  counter_.histogram(static_cast<double>(image.rows) * image.cols, std::get<SparseVector>(feature));
}

void Mr8Extractor::countRow(int y) {
  const float levels = static_cast<float>(options_.bins);
  const float range = static_cast<float>(options_.range);
  std::array<const float*, Mr8FilterBank::kResponses> rows;
  for (int k = 0; k < Mr8FilterBank::kResponses; ++k) rows[k] = responses_[k][y];
  for (std::size_t x = 0; x < bins_.size(); ++x) {
    float square = 0;
    for (const float* row : rows) square += row[x] * row[x];
    const float norm = std::sqrt(square);
    const float gain = options_.weber && norm > 0 ? std::log1p(norm / kWeberContrast) / norm : 1.0f;
    std::uint64_t bin = 0;
    for (int k = Mr8FilterBank::kResponses - 1; k >= 0; --k) {
      const float share = gain * rows[k][x] / range;
      const float level = levels * (k < kSigned ? share : 0.5f * (share + 1));
      bin = bin * options_.bins + static_cast<std::uint64_t>(std::clamp(level, 0.0f, levels - 1));
    }
    bins_[x] = bin;
  }
}

}  // namespace place_recognition
