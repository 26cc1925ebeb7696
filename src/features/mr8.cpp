#include "features/mr8.h"

#include <cmath>

#include "base/require.h"

namespace place_recognition {

namespace {

constexpr int kSigned = 2 * Mr8FilterBank::kScales;  ///< index of the first signed response
constexpr int kDigitsOfWord = 4;  ///< of at most 200 values each, so that a word fits in 32 bits

/// Quantizes magnitudes over 0..range and other responses over -range..range.
Quantizer quantizer(const Mr8Options& options, int response) {
  const bool is_signed = response >= kSigned;
  const auto bins = static_cast<float>(options.bins);
  const float zero = is_signed ? bins / 2 : 0;  // the level of zero
  const float whole = std::floor(zero);
  const auto weight = std::pow(options.bins, response % kDigitsOfWord);
  return {(bins - zero) / static_cast<float>(options.range), zero - whole, -whole, bins - 1 - whole,
          static_cast<std::uint32_t>(weight)};
}

}  // namespace

void Mr8Options::check(const std::string& key) const {
  requireOption(bins >= 2 && bins <= 200, key + ".bins", bins, "2 to 200");
  requireOption(range > 0 && std::isfinite(range), key + ".range", range, "a number above 0");
}

Mr8Extractor::Mr8Extractor(const Mr8Options& options)
    : options_(options), responses_(options.weber) {
  options_.check();
  for (int k = 0; k < Mr8FilterBank::kResponses; ++k) quantizers_[k] = quantizer(options, k);
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
  const int columns = static_cast<int>(bins_.size());
  word_.resize(bins_.size());
  std::uint64_t weight = 1;
  for (int first = 0; first < Mr8FilterBank::kResponses; first += kDigitsOfWord) {
    for (int k = first; k < first + kDigitsOfWord; ++k) {
      quantize(responses[k][y], quantizers_[k], k > first, columns, word_.data());
    }
    joinWord(word_.data(), weight, first > 0, columns, bins_.data());
    for (int k = 0; k < kDigitsOfWord; ++k) weight *= options_.bins;
  }
}

}  // namespace place_recognition
