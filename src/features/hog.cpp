#include "features/hog.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "base/require.h"
#include "base/text.h"
#include "features/grey_levels.h"

namespace place_recognition {
namespace {

constexpr int kLargestDifference = 255;

}  // namespace

void HogOptions::check(const std::string& key) const {
  requireOption(rows >= 1 && rows <= 16, key + ".rows", rows, "1 to 16");
  requireOption(columns >= 1 && columns <= 16, key + ".columns", columns, "1 to 16");
  requireOption(orientations >= 2 && orientations <= 36, key + ".orientations", orientations,
                "2 to 36");
  requireOption(width >= 32 && width <= 1024, key + ".width", width, "32 to 1024 pixels");
}

HogExtractor::HogExtractor(const HogOptions& options) : options_(options) {
  options_.check();
  const int count = options_.orientations;
  for (int dy = 0; dy <= kLargestDifference; ++dy) {
    for (int dx = -kLargestDifference; dx <= kLargestDifference; ++dx) {
      const double magnitude = std::hypot(dx, dy);
      const double orientation = std::atan2(dy, dx) / CV_PI * count - 0.5;  // -0.5 .. count - 0.5
      const double lower = std::floor(orientation);
      const int first = static_cast<int>(lower);
      const double share = orientation - lower;
      votes_.push_back(
          {{static_cast<std::uint8_t>((first + count) % count),
            static_cast<std::uint8_t>((first + 1) % count)},
           {static_cast<float>(magnitude * (1 - share)), static_cast<float>(magnitude * share)}});
    }
  }
}

/// The vote for a gradient; that of the opposite gradient is the same.
const HogExtractor::Vote& HogExtractor::voteFor(int dx, int dy) const {
  const int sign = dy < 0 ? -1 : 1;
  const int row = sign * dy;
  const int column = sign * dx + kLargestDifference;
  return votes_[static_cast<std::size_t>(row * (2 * kLargestDifference + 1) + column)];
}

/// The grey levels of the image at its final size.
const cv::Mat& HogExtractor::prepare(const cv::Mat& image) {
  const cv::Mat& grey = greyLevels(image, converted_);
  if (image.cols <= options_.width) return grey;
  const double height = static_cast<double>(image.rows) * options_.width / image.cols;
  const cv::Size size(options_.width, std::max(1, static_cast<int>(std::lround(height))));
  cv::resize(grey, scaled_, size, 0, 0, cv::INTER_AREA);
  return scaled_;
}

/// Adds the votes of a row of pixels.
void HogExtractor::addRow(const cv::Mat& grey, int y) {
  const std::uint8_t* const above = grey.ptr<std::uint8_t>(y - 1);
  const std::uint8_t* const row = grey.ptr<std::uint8_t>(y);
  const std::uint8_t* const below = grey.ptr<std::uint8_t>(y + 1);
  const int width = grey.cols - 2;
  const int cell_row = (y - 1) * options_.rows / (grey.rows - 2);
  double* sums =
      &sums_[static_cast<std::size_t>(cell_row * options_.columns * options_.orientations)];
  int x = 1;
  for (int column = 0; column < options_.columns; ++column, sums += options_.orientations) {
    // The pixels x for which (x - 1) * columns / width is this column.
    const int end = 1 + ((column + 1) * width + options_.columns - 1) / options_.columns;
    for (; x < end; ++x) {
      const Vote& vote = voteFor(row[x + 1] - row[x - 1], below[x] - above[x]);
      sums[vote.orientations[0]] += vote.magnitudes[0];
      sums[vote.orientations[1]] += vote.magnitudes[1];
    }
  }
}

void HogExtractor::extract(const cv::Mat& image, Feature& feature) {
  const cv::Mat& grey = prepare(image);
  sums_.assign(options_.dimension(), 0);
  const bool fits = grey.rows - 2 >= options_.rows && grey.cols - 2 >= options_.columns;
  for (int y = 1; fits && y + 1 < grey.rows; ++y) addRow(grey, y);
  const double total = std::accumulate(sums_.begin(), sums_.end(), 0.0);
  if (total == 0) {
    missing_reason_ = fits ? "the image has no gradient"
                           : "the image of " + sizeText(image.cols, image.rows) +
                                 " pixels is too small for its cells";
    feature = std::monostate();
    return;
  }
  if (!std::holds_alternative<DenseVector>(feature)) feature = DenseVector();
  std::vector<float>& values = std::get<DenseVector>(feature).values;
  values.clear();
  for (const double sum : sums_) values.push_back(static_cast<float>(sum / total));
}

}  // namespace place_recognition
