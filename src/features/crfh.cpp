#include "features/crfh.h"

#include <algorithm>

#include "features/crfh_descriptor.h"
#include "features/crfh_quantizer.h"

namespace place_recognition {
namespace {

constexpr std::uint64_t kWordSize = std::uint64_t{1} << 32;

}  // namespace

CrfhExtractor::CrfhExtractor(const CrfhOptions& options) {
  options.check();
  std::uint64_t bins_in_word = 1;
  std::uint64_t bins_so_far = 1;
  for (double t : options.variances()) {
    for (std::size_t i = 0; i < options.descriptors.size(); ++i) {
      const CrfhDescriptor descriptor = parseDescriptor(options.descriptors[i]);
      const std::uint64_t bins = options.bins[options.bins.size() > 1 ? i : 0];
      const bool first_in_word = words_.empty() || bins_in_word * bins > kWordSize;
      if (first_in_word) {
        words_.push_back({bins_so_far, {}});
        bins_in_word = 1;
      }
      const std::size_t filter = filterOf(descriptor.channel, t, options);
      filters_[filter].responses.request(descriptor.op);
      dimensions_.push_back({filter, descriptor.op, words_.size() - 1, first_in_word,
                             crfhQuantizer(descriptor, t, options.derivative_range,
                                           static_cast<int>(bins), bins_in_word)});
      bins_in_word *= bins;
      bins_so_far *= bins;
    }
  }
  for (const Filter& filter : filters_) margin_ = std::max(margin_, filter.responses.margin());
  border_ = std::max(options.border, margin_);
}

std::size_t CrfhExtractor::planeOf(Channel channel) {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_[i].channel == channel) return i;
  }
  planes_.push_back({channel, {}});
  return planes_.size() - 1;
}

std::size_t CrfhExtractor::filterOf(Channel channel, double t, const CrfhOptions& options) {
  const std::size_t plane = planeOf(channel);
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    if (filters_[i].plane == plane && filters_[i].t == t) return i;
  }
  const auto method = options.derivatives == "gaussian" ? DerivativeMethod::kGaussian
                                                        : DerivativeMethod::kCentralDifference;
  filters_.push_back({plane, t, ResponseFilter(t, options.half_width, method)});
  return filters_.size() - 1;
}

void CrfhExtractor::extract(const cv::Mat& image, Feature& feature) {
  const int columns = image.cols - 2 * border_;
  const int rows = image.rows - 2 * border_;
  if (columns <= 0 || rows <= 0) {
    missing_reason_ = "the image of " + std::to_string(image.cols) + " x " +
                      std::to_string(image.rows) + " pixels has no pixel farther than " +
                      std::to_string(border_) + " from its edges";
    feature = std::monostate();
    return;
  }
  for (Plane& plane : planes_) plane.pixels.create(image.size());
  for (Word& word : words_) word.row.resize(columns);
  bins_.resize(columns);

  counter_.clear();
  int next_row = 0;
  for (int y = border_; y < border_ + rows; ++y) {
    // Just before they are needed, so that they are still in the processor's cache then.
    for (; next_row <= y + margin_; ++next_row) extractRow(image, next_row);
    countRow(y, columns);
  }

  if (!std::holds_alternative<SparseVector>(feature)) feature = SparseVector();
  counter_.histogram(static_cast<double>(rows) * columns, std::get<SparseVector>(feature));
}

void CrfhExtractor::extractRow(const cv::Mat& image, int y) {
  for (Plane& plane : planes_) extractChannelRow(image, plane.channel, y, plane.pixels[y]);
}

void CrfhExtractor::countRow(int y, int columns) {
  for (Filter& filter : filters_) {
    filter.responses.computeRow(planes_[filter.plane].pixels, y, border_, columns);
  }
  for (const Dimension& dimension : dimensions_) {
    quantize(filters_[dimension.filter].responses.row(dimension.op), dimension.quantizer,
             !dimension.first_in_word, columns, words_[dimension.word].row.data());
  }
  for (const Word& word : words_) {
    joinWord(word.row.data(), word.weight, &word != &words_[0], columns, bins_.data());
  }
  counter_.add(bins_.data(), bins_.size());
}

}  // namespace place_recognition
