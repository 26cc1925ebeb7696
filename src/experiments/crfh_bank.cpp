#include "experiments/crfh_bank.h"

#include <algorithm>

namespace place_recognition {

CrfhBank::CrfhBank(const std::vector<CrfhOptions>& histograms) : responses_(histograms.front()) {
  for (const CrfhOptions& options : histograms) {
    options.check();
    std::vector<Dimension>& dimensions = histograms_.emplace_back();
    std::uint64_t weight = 1;
    for (const double t : options.variances()) {
      for (std::size_t i = 0; i < options.descriptors.size(); ++i) {
        const int bins = options.bins[options.bins.size() > 1 ? i : 0];
        dimensions.push_back(
            {digitsOf(parseDescriptor(options.descriptors[i]), t, bins, options), weight});
        weight *= static_cast<std::uint64_t>(bins);
      }
    }
    border_ = std::max(border_, options.border);
  }
  border_ = std::max(border_, responses_.margin());
}

std::size_t CrfhBank::digitsOf(const CrfhDescriptor& descriptor, double t, int bins,
                               const CrfhOptions& options) {
  const CrfhResponses::Response response = responses_.request(descriptor, t);
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const Digits& digits = digits_[i];
    if (digits.response == response && digits.bins == bins) return i;
  }
  digits_.push_back(
      {response, bins, crfhQuantizer(descriptor, t, options.derivative_range, bins, 1), {}});
  return digits_.size() - 1;
}

std::vector<Feature> CrfhBank::extract(const cv::Mat& image) {
  std::vector<Feature> features(histograms_.size());
  const int columns = image.cols - 2 * border_;
  const int rows = image.rows - 2 * border_;
  if (columns <= 0 || rows <= 0) return features;
  quantizeAll(image, columns, rows);
  const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (std::size_t h = 0; h < features.size(); ++h) count(histograms_[h], pixels, features[h]);
  return features;
}

void CrfhBank::quantizeAll(const cv::Mat& image, int columns, int rows) {
  const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (Digits& digits : digits_) digits.pixels.resize(pixels);
  responses_.start(image.size(), border_);
  const StripedRows& lanes = responses_.lanes();
  row_.resize(lanes.size());
  std::ptrdiff_t begin = 0;
  while (const int count = responses_.computeRows(image)) {
    for (int r = 0; r < count; ++r, begin += columns) {
      for (Digits& digits : digits_) {
        quantize(responses_.row(digits.response, r), digits.quantizer, false, lanes.size(),
                 row_.data());
        lanes.take(columns, row_.data(), row_.data());
        std::copy_n(row_.begin(), columns, digits.pixels.begin() + begin);
      }
    }
  }
}

void CrfhBank::count(const std::vector<Dimension>& histogram, std::size_t pixels,
                     Feature& feature) {
  constexpr std::size_t kBlock = 2048;  // fits into the processor's cache
  bins_.resize(kBlock);
  counter_.clear();
  for (std::size_t begin = 0; begin < pixels; begin += kBlock) {
    const std::size_t n = std::min(kBlock, pixels - begin);
    bool add = false;
    for (const Dimension& dimension : histogram) {
      joinWord(digits_[dimension.digits].pixels.data() + begin, dimension.weight, add,
               static_cast<int>(n), bins_.data());
      add = true;
    }
    counter_.add(bins_.data(), n);
  }
  counter_.histogram(static_cast<double>(pixels), feature.emplace<SparseVector>());
}

}  // namespace place_recognition
