#include "features/crfh.h"

#include <algorithm>

#include "base/text.h"
#include "features/crfh_descriptor.h"
#include "features/logarithmic_levels.h"

namespace place_recognition {
namespace {

constexpr std::uint64_t kWordSize = std::uint64_t{1} << 32;

}  // namespace

CrfhExtractor::CrfhExtractor(const CrfhOptions& options)
    : logarithmic_(options.levels == "logarithmic"), responses_(options) {
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
      dimensions_.push_back({responses_.request(descriptor, t), words_.size() - 1, first_in_word,
                             crfhQuantizer(descriptor, t, options.derivative_range,
                                           static_cast<int>(bins), bins_in_word)});
      bins_in_word *= bins;
      bins_so_far *= bins;
    }
  }
  border_ = std::max(options.border, responses_.margin());
}

void CrfhExtractor::extract(const cv::Mat& image, Feature& feature) {
  const int columns = image.cols - 2 * border_;
  const int rows = image.rows - 2 * border_;
  if (columns <= 0 || rows <= 0) {
    missing_reason_ = "the image of " + sizeText(image.cols, image.rows) +
                      " pixels has no pixel farther than " + std::to_string(border_) +
                      " from its edges";
    feature = std::monostate();
    return;
  }
  responses_.start(image.size(), border_);
  for (Word& word : words_) word.row.resize(responses_.lanes().size());
  bins_.resize(columns);

  counter_.clear();
  const cv::Mat& levels = inLevels(image);
  while (const int count = responses_.computeRows(levels)) {
    for (int r = 0; r < count; ++r) countRow(r, columns);
  }

  if (!std::holds_alternative<SparseVector>(feature)) feature = SparseVector();
  counter_.histogram(static_cast<double>(rows) * columns, std::get<SparseVector>(feature));
}

const cv::Mat& CrfhExtractor::inLevels(const cv::Mat& image) {
  if (!logarithmic_) return image;
  takeLogarithms(image, levels_);
  return levels_;
}

void CrfhExtractor::countRow(int r, int columns) {
  for (const Dimension& dimension : dimensions_) {
    quantize(responses_.row(dimension.response, r), dimension.quantizer, !dimension.first_in_word,
             responses_.lanes().size(), words_[dimension.word].row.data());
  }
  for (Word& word : words_) {
    responses_.lanes().take(columns, word.row.data(), word.row.data());
    joinWord(word.row.data(), word.weight, &word != &words_[0], columns, bins_.data());
  }
  counter_.add(bins_.data(), bins_.size());
}

}  // namespace place_recognition
