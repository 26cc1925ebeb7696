#include "features/mr8.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "place_recognition/error.h"

namespace place_recognition {

namespace {

constexpr int kSigned = 2 * Mr8FilterBank::kScales;  ///< the first response that may be negative

}  // namespace

void Mr8Options::check() const {
  if (bins < 2 || bins > 200) {
    throw Error("MR8 option 'bins' is " + std::to_string(bins) + "; give a number from 2 to 200.");
  }
  if (!(range > 0 && std::isfinite(range))) throw Error("MR8 option 'range' must be positive.");
}

Mr8Extractor::Mr8Extractor(const Mr8Options& options)
    : options_(options), responses_(options.weber) {
  options_.check();
}

void Mr8Extractor::extract(const cv::Mat& image, Feature& feature) {
  const Mr8FilterBank::Responses& responses = responses_.of(image);
  bins_.resize(image.cols);
  counter_.clear();
  for (int y = 0; y < image.rows; ++y) {
    countRow(responses, y);
    counter_.add(bins_.data(), bins_.size());
  }
  if (!std::holds_alternative<SparseVector>(feature)) feature = SparseVector();
  counter_.histogram(static_cast<double>(image.rows) * image.cols, std::get<SparseVector>(feature));
}

void Mr8Extractor::countRow(const Mr8FilterBank::Responses& responses, int y) {
  const float levels = static_cast<float>(options_.bins);
  const float range = static_cast<float>(options_.range);
  std::array<const float*, Mr8FilterBank::kResponses> rows;
  for (int k = 0; k < Mr8FilterBank::kResponses; ++k) rows[k] = responses[k][y];
  for (std::size_t x = 0; x < bins_.size(); ++x) {
    std::uint64_t bin = 0;
    for (int k = Mr8FilterBank::kResponses - 1; k >= 0; --k) {
      const float fraction = rows[k][x] / range;
      const float level = levels * (k < kSigned ? fraction : 0.5f * (fraction + 1));
      bin = bin * options_.bins + static_cast<std::uint64_t>(std::clamp(level, 0.0f, levels - 1));
    }
    bins_[x] = bin;
  }
}

}  // namespace place_recognition
