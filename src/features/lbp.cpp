#include "features/lbp.h"

#include <algorithm>
#include <cmath>

#include "base/require.h"
#include "base/simd.h"
#include "features/grey_levels.h"

namespace place_recognition {

namespace {

/// Positions are rounded to 2^-11 pixel, so that weights, which are products of two, times 255 fit
/// into 31 bits.
constexpr int kPositionBits = 11;
constexpr int kWeightBits = 2 * kPositionBits;

/// Adds to `ones` whether the neighbour of each pixel is at least as bright as the centre, adds to
/// `changes` whether this differs from the previous neighbour, `last`, and updates `last`.
PLACE_RECOGNITION_TARGET_CLONES
void compareNeighbour(const std::uint8_t* centre, const std::array<const std::uint8_t*, 4>& pixels,
                      const std::array<std::int32_t, 4>& weights, int count,
                      std::int32_t* __restrict ones, std::int32_t* __restrict changes,
                      std::int32_t* __restrict last) {
  const auto [a, b, c, d] = pixels;
  const auto [wa, wb, wc, wd] = weights;
  for (int x = 0; x < count; ++x) {
    const std::int32_t value = wa * a[x] + wb * b[x] + wc * c[x] + wd * d[x];
    const std::int32_t bit = value >= (centre[x] << kWeightBits) ? 1 : 0;
    ones[x] += bit;
    changes[x] += bit ^ last[x];
    last[x] = bit;
  }
}

}  // namespace

void LbpOptions::check(const std::string& key) const {
  requireSome(circles, key + ".circles", "at least one circle");
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto& [points, radius] = circles[i];
    const std::string circle = key + ".circles." + std::to_string(i);
    requireOption(points >= 4 && points <= 32, circle + ".points", points, "4 to 32");
    requireOption(radius >= 0.5 && radius <= 16, circle + ".radius", radius, "0.5 to 16 pixels");
  }
}

LbpOperator::LbpOperator(const LbpCircle& circle)
    : border_(static_cast<int>(std::ceil(circle.radius))) {
  for (int i = 0; i < circle.points; ++i) {
    const double angle = 2 * CV_PI * i / circle.points;
    neighbours_.push_back(
        neighbourAt(circle.radius * std::cos(angle), circle.radius * std::sin(angle)));
  }
}

LbpOperator::Neighbour LbpOperator::neighbourAt(double dx, double dy) {
  constexpr int kOne = 1 << kPositionBits;
  const int x = static_cast<int>(std::lround(dx * kOne));
  const int y = static_cast<int>(std::lround(dy * kOne));
  const int left = static_cast<int>(std::floor(x / static_cast<double>(kOne)));
  const int top = static_cast<int>(std::floor(y / static_cast<double>(kOne)));
  const int fx = x - left * kOne;
  const int fy = y - top * kOne;
  // A neighbour exactly on a column or row does not need the next one.
  const int right = fx > 0 ? left + 1 : left;
  const int bottom = fy > 0 ? top + 1 : top;
  return {{{{left, top}, {right, top}, {left, bottom}, {right, bottom}}},
          {(kOne - fx) * (kOne - fy), fx * (kOne - fy), (kOne - fx) * fy, fx * fy}};
}

const std::vector<std::int32_t>& LbpOperator::encodeRow(const cv::Mat1b& image, int y) {
  const int count = image.cols - 2 * border_;
  for (auto* row : {&ones_, &changes_, &last_}) row->assign(count, 0);
  codes_.resize(count);
  for (const Neighbour& neighbour : neighbours_) {
    std::array<const std::uint8_t*, 4> pixels;
    for (int i = 0; i < 4; ++i) {
      pixels[i] = image[y + neighbour.pixels[i].y] + border_ + neighbour.pixels[i].x;
    }
    compareNeighbour(image[y] + border_, pixels, neighbour.weights, count, ones_.data(),
                     changes_.data(), last_.data());
    if (&neighbour == &neighbours_.front()) first_ = changes_;
  }
  // The first neighbour was not compared yet; it follows the last one.
  const int other = codes() - 1;
  for (int x = 0; x < count; ++x) {
    const int changes = changes_[x] - first_[x] + (first_[x] ^ last_[x]);
    codes_[x] = changes <= 2 ? ones_[x] : other;
  }
  return codes_;
}

LbpExtractor::LbpExtractor(const LbpOptions& options) {
  options.check();
  for (const LbpCircle& circle : options.circles) operators_.emplace_back(circle);
}

void LbpExtractor::extract(const cv::Mat& image, Feature& feature) {
  int border = 0;
  for (const LbpOperator& op : operators_) border = std::max(border, op.border());
  if (std::min(image.cols, image.rows) <= 2 * border) {
    missing_reason_ = "the image of " + sizeText(image.cols, image.rows) +
                      " pixels has no pixel farther than " + std::to_string(border) +
                      " from its edges";
    feature = std::monostate();
    return;
  }
  const cv::Mat1b grey = greyLevels(image, converted_);
  if (!std::holds_alternative<DenseVector>(feature)) feature = DenseVector();
  std::vector<float>& values = std::get<DenseVector>(feature).values;
  values.clear();
  for (LbpOperator& op : operators_) {
    std::vector<std::uint32_t> counts(op.codes());
    for (int y = op.border(); y < grey.rows - op.border(); ++y) {
      for (const std::int32_t code : op.encodeRow(grey, y)) ++counts[code];
    }
    const double total =
        static_cast<double>(grey.rows - 2 * op.border()) * (grey.cols - 2 * op.border());
    for (const std::uint32_t count : counts) values.push_back(static_cast<float>(count / total));
  }
}

}  // namespace place_recognition
