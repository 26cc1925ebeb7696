#include "features/sift_descriptor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/simd.h"

namespace place_recognition {

namespace {

constexpr float kPi = 3.14159265358979f;
constexpr int kPeakBins = 36;
constexpr float kPeakRatio = 0.8f;
constexpr float kPeakWindow = 1.5f;    ///< sigma of the window, in scales
constexpr float kBinWidth = 3;         ///< width of one of the 4 x 4 histograms, in scales
constexpr float kLargestValue = 0.2f;  ///< of the normalized descriptor; limits the effect of glare

// The histograms have one more cell on each side and two more directions, so that a sample can be
// distributed without checking its position; the rim is dropped, and the directions wrap around.
constexpr int kGrid = SiftDescriptor::kGrid;
constexpr int kDirections = SiftDescriptor::kOrientations;
constexpr int kCell = kDirections + 2;
constexpr int kCellRow = (kGrid + 2) * kCell;
constexpr int kCells = (kGrid + 2) * kCellRow;

/// atan2 with an error below 1e-5 radians, without branches.
inline float angleOf(float dy, float dx) {
  const float ax = std::fabs(dx);
  const float ay = std::fabs(dy);
  const float larger = std::max(ax, ay);
  const float ratio = std::min(ax, ay) / std::max(larger, 1e-20f);
  const float s = ratio * ratio;
  float angle = -0.01172120f;
  angle = angle * s + 0.05265332f;
  angle = angle * s - 0.11643287f;
  angle = angle * s + 0.19354346f;
  angle = angle * s - 0.33262347f;
  angle = (angle * s + 0.99997726f) * ratio;
  angle = ay > ax ? 0.5f * kPi - angle : angle;
  angle = dx < 0 ? kPi - angle : angle;
  return dy < 0 ? -angle : angle;
}

/// Magnitude (times window) and angle of eq. 4.27 for `count` pixels of the row `here`.
PLACE_RECOGNITION_TARGET_CLONES
void toPolar(const float* above, const float* here, const float* below, int count,
             const float* window, float row_weight, float* __restrict magnitude,
             float* __restrict angle) {
  for (int i = 0; i < count; ++i) {
    const float dx = here[i + 1] - here[i - 1];
    const float dy = below[i] - above[i];
    magnitude[i] = std::sqrt(dx * dx + dy * dy) * (row_weight * window[i]);
    angle[i] = angleOf(dy, dx);
  }
}

/// A straight row of samples in the descriptor's rotated grid: the column and row of sample i,
/// counted from the centre of the rim's first cell, are start + i * step.
struct GridLine {
  float column, column_step;
  float row, row_step;
};

/// Computes the bin of each sample. `angle` becomes the fraction towards the next direction.
PLACE_RECOGNITION_TARGET_CLONES
void toBins(const GridLine& line, float turned, int count, float* __restrict angle,
            float* __restrict row_fraction, float* __restrict column_fraction,
            int* __restrict bin) {
  constexpr float kEnd = kGrid + 0.9999f;  // guards against rounding at the rim's edge
  constexpr float kPerRadian = kDirections / (2 * kPi);
  for (int i = 0; i < count; ++i) {
    const float row = std::min(std::max(line.row + i * line.row_step, 0.0f), kEnd);
    const float column = std::min(std::max(line.column + i * line.column_step, 0.0f), kEnd);
    const float relative = (turned - angle[i]) * kPerRadian;
    const float direction = relative < 0 ? relative + kDirections : relative;
    const int r = static_cast<int>(row);
    const int c = static_cast<int>(column);
    const int d = static_cast<int>(direction);
    row_fraction[i] = row - r;
    column_fraction[i] = column - c;
    angle[i] = direction - d;
    bin[i] = r * kCellRow + c * kCell + d;
  }
}

/// Narrows first..last to the range where |offset + slope * t| <= limit.
void narrow(float offset, float slope, float limit, float& first, float& last) {
  if (std::fabs(slope) < 1e-6f) {
    if (std::fabs(offset) > limit) last = first - 1;
    return;
  }
  const float a = (-limit - offset) / slope;
  const float b = (limit - offset) / slope;
  first = std::max(first, std::min(a, b));
  last = std::min(last, std::max(a, b));
}

/// Smooths a circular histogram with [1 4 6 4 1] / 16.
std::array<float, kPeakBins> smoothed(const std::array<float, kPeakBins>& h) {
  std::array<float, kPeakBins> out;
  const auto at = [&h](int i) { return h[(i + kPeakBins) % kPeakBins]; };
  for (int i = 0; i < kPeakBins; ++i) {
    out[i] = (at(i - 2) + at(i + 2)) / 16 + (at(i - 1) + at(i + 1)) / 4 + at(i) * 3 / 8;
  }
  return out;
}

void normalize(const float* cells, std::uint8_t* descriptor) {
  std::array<float, SiftDescriptor::kDimension> values;
  float square = 0;
  for (int r = 0, i = 0; r < kGrid; ++r) {
    for (int c = 0; c < kGrid; ++c) {
      const float* cell = cells + (r + 1) * kCellRow + (c + 1) * kCell;
      for (int d = 0; d < kDirections; ++d, ++i) {
        values[i] = cell[d] + (d < kCell - kDirections ? cell[kDirections + d] : 0);
        square += values[i] * values[i];
      }
    }
  }
  const float limit = kLargestValue * std::sqrt(square);
  square = 0;
  for (float& value : values) {
    value = std::min(value, limit);
    square += value * value;
  }
  const float unit = 512 / std::max(std::sqrt(square), 1e-12f);
  for (int i = 0; i < SiftDescriptor::kDimension; ++i) {
    descriptor[i] = static_cast<std::uint8_t>(std::min(values[i] * unit + 0.5f, 255.0f));
  }
}

}  // namespace

void SiftDescriptor::prepareWindow(float x, float y, int radius, float sigma) {
  const std::size_t size = 2 * radius + 1;
  for (std::vector<float>* buffer : {&window_x_, &window_y_, &samples_.magnitude, &samples_.angle,
                                     &samples_.row_fraction, &samples_.column_fraction}) {
    buffer->resize(size);
  }
  samples_.bin.resize(size);
  const float factor = -0.5f / (sigma * sigma);
  for (int i = 0; i <= 2 * radius; ++i) {
    const float dx = std::round(x) - radius + i - x;
    const float dy = std::round(y) - radius + i - y;
    window_x_[i] = std::exp(factor * dx * dx);
    window_y_[i] = std::exp(factor * dy * dy);
  }
}

const std::vector<float>& SiftDescriptor::orientations(const cv::Mat1f& level, float x, float y,
                                                       float sigma) {
  const float width = kPeakWindow * sigma;
  const int radius = static_cast<int>(std::lround(3 * width));
  prepareWindow(x, y, radius, width);
  const int left = static_cast<int>(std::lround(x)) - radius;
  const int top = static_cast<int>(std::lround(y)) - radius;
  const int begin = std::max(left, 1);
  const int count = std::min(left + 2 * radius, level.cols - 2) - begin + 1;
  std::array<float, kPeakBins> histogram{};
  const int end_row = std::min(top + 2 * radius, level.rows - 2);
  for (int row = std::max(top, 1); row <= end_row; ++row) {
    toPolar(level[row - 1] + begin, level[row] + begin, level[row + 1] + begin, count,
            window_x_.data() + (begin - left), window_y_[row - top], samples_.magnitude.data(),
            samples_.angle.data());
    for (int i = 0; i < count; ++i) {
      const float bin = samples_.angle[i] * (kPeakBins / (2 * kPi)) + kPeakBins + 0.5f;
      histogram[static_cast<int>(bin) % kPeakBins] += samples_.magnitude[i];
    }
  }
  histogram = smoothed(histogram);

  orientations_.clear();
  const float highest = *std::max_element(histogram.begin(), histogram.end());
  for (int i = 0; i < kPeakBins; ++i) {
    const float before = histogram[(i + kPeakBins - 1) % kPeakBins];
    const float after = histogram[(i + 1) % kPeakBins];
    if (histogram[i] <= before || histogram[i] < after || histogram[i] < kPeakRatio * highest) {
      continue;
    }
    const float peak = i + 0.5f * (before - after) / (before - 2 * histogram[i] + after);
    const float angle = peak * (2 * kPi / kPeakBins);
    orientations_.push_back(angle > kPi ? angle - 2 * kPi : angle);
  }
  return orientations_;
}

void SiftDescriptor::distribute(int count, float* cells) const {
  for (int i = 0; i < count; ++i) {
    const float lower = samples_.magnitude[i] * samples_.row_fraction[i];
    const float upper = samples_.magnitude[i] - lower;
    const float lower_right = lower * samples_.column_fraction[i];
    const float lower_left = lower - lower_right;
    const float upper_right = upper * samples_.column_fraction[i];
    const float upper_left = upper - upper_right;
    const float next = samples_.angle[i];
    float* bin = cells + samples_.bin[i];
    bin[0] += upper_left - upper_left * next;
    bin[1] += upper_left * next;
    bin[kCell] += upper_right - upper_right * next;
    bin[kCell + 1] += upper_right * next;
    bin[kCellRow] += lower_left - lower_left * next;
    bin[kCellRow + 1] += lower_left * next;
    bin[kCellRow + kCell] += lower_right - lower_right * next;
    bin[kCellRow + kCell + 1] += lower_right * next;
  }
}

void SiftDescriptor::describe(const cv::Mat1f& level, float x, float y, float sigma, float angle,
                              std::uint8_t* descriptor) {
  constexpr float kReach = 0.5f * (kGrid + 1);  // centre to the rim's cell centres, in cells
  const float cell = kBinWidth * sigma;
  const int radius = static_cast<int>(std::lround(std::sqrt(2.0f) * kReach * cell));
  prepareWindow(x, y, radius, 0.5f * kGrid * cell);
  const float cosine = std::cos(angle) / cell;
  const float sine = std::sin(angle) / cell;
  const int left = static_cast<int>(std::lround(x)) - radius;
  const int top = static_cast<int>(std::lround(y)) - radius;
  std::array<float, kCells> cells{};

  const int end_row = std::min(top + 2 * radius, level.rows - 2);
  for (int row = std::max(top, 1); row <= end_row; ++row) {
    // In cells from the centre, a pixel at (dx, dy) is in column dx cosine + dy sine and row -dx
    // sine + dy cosine.
    const float dy = row - y;
    float first = std::max(left, 1) - x;
    float last = std::min(left + 2 * radius, level.cols - 2) - x;
    narrow(dy * sine, cosine, kReach, first, last);
    narrow(dy * cosine, -sine, kReach, first, last);
    const int begin = static_cast<int>(std::ceil(first + x));
    const int count = static_cast<int>(std::floor(last + x)) - begin + 1;
    if (count <= 0) continue;

    toPolar(level[row - 1] + begin, level[row] + begin, level[row + 1] + begin, count,
            window_x_.data() + (begin - left), window_y_[row - top], samples_.magnitude.data(),
            samples_.angle.data());
    const float dx = begin - x;
    const GridLine line{dx * cosine + dy * sine + kReach, cosine, -dx * sine + dy * cosine + kReach,
                        -sine};
    toBins(line, angle, count, samples_.angle.data(), samples_.row_fraction.data(),
           samples_.column_fraction.data(), samples_.bin.data());
    distribute(count, cells.data());
  }
  normalize(cells.data(), descriptor);
}

}  // namespace place_recognition
