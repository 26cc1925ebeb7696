#include "features/harris_laplace.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/simd.h"
#include "features/subpixel_laplacian.h"

namespace place_recognition {

namespace {

/// Half-width of the integration window, in sigma_I.
constexpr double kWindowHalfWidth = 3;
/// Minimum distance of corners from the edge, in pixels of the octave; what is beyond the edge is
/// only a mirror image.
constexpr int kBorder = 4;
// A corner is detected at several differentiation scales. Points closer than this are merged. With
// half the distance, the strongest points of an image cover fewer places, and fewer of them are
// found again in other light.
constexpr float kSameDistance = 1;  ///< in scales of the smaller
constexpr float kSameScaleRatio = 1.3f;

/// Products of the first derivatives (central differences) of row `here`, for eq. 4.25. The image
/// is mirrored, so the horizontal derivative at its left and right edges is zero.
PLACE_RECOGNITION_TARGET_CLONES
void multiplyGradients(const float* above, const float* here, const float* below, int width,
                       float* __restrict xx, float* __restrict xy, float* __restrict yy) {
  for (int x = 1; x < width - 1; ++x) {
    const float dx = 0.5f * (here[x + 1] - here[x - 1]);
    const float dy = 0.5f * (below[x] - above[x]);
    xx[x] = dx * dx;
    xy[x] = dx * dy;
    yy[x] = dy * dy;
  }
  for (const int x : {0, width - 1}) {
    const float dy = 0.5f * (below[x] - above[x]);
    xx[x] = 0;
    xy[x] = 0;
    yy[x] = dy * dy;
  }
}

/// Eq. 4.26 of t_D times the matrices [xx xy; xy yy].
PLACE_RECOGNITION_TARGET_CLONES
void combineMoments(const float* xx, const float* xy, const float* yy, int width, float t,
                    float alpha, float* __restrict cornerness) {
  for (int x = 0; x < width; ++x) {
    const float trace = xx[x] + yy[x];
    cornerness[x] = t * t * (xx[x] * yy[x] - xy[x] * xy[x] - alpha * trace * trace);
  }
}

/// Whether each pixel of row `here` exceeds the threshold and its eight neighbours; of two equal
/// neighbours, the later one in raster order counts as lower.
PLACE_RECOGNITION_TARGET_CLONES
void markPeaks(const float* above, const float* here, const float* below, int width,
               float threshold, unsigned char* __restrict is_peak) {
  for (int x = 1; x < width - 1; ++x) {
    const float before = std::max(std::max(std::max(above[x - 1], above[x]), above[x + 1]),
                                  std::max(here[x - 1], threshold));
    const float after =
        std::max(std::max(std::max(below[x - 1], below[x]), below[x + 1]), here[x + 1]);
    is_peak[x] = (here[x] > before) & (here[x] >= after);
  }
}

/// Position of the maximum of the parabola through three values, of which the middle one is
/// largest.
double peakOffset(double before, double middle, double after) {
  const double curvature = before - 2 * middle + after;
  return curvature < 0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0;
}

bool isSame(const InterestPoint& a, const InterestPoint& b) {
  const float smaller = std::min(a.sigma, b.sigma);
  const float dx = a.x - b.x, dy = a.y - b.y;
  const float reach = kSameDistance * smaller;
  return dx * dx + dy * dy < reach * reach &&
         std::max(a.sigma, b.sigma) < kSameScaleRatio * smaller;
}

}  // namespace

HarrisLaplace::HarrisLaplace(const Options& options)
    : options_(options),
      integration_offset_(options.steps / 2),
      pyramid_(options.sigma / std::sqrt(2.0), options.steps, integration_offset_,
               options.octaves) {
  for (int s = 0; s < options.steps; ++s) {
    const double sigma = pyramid_.sigma(s + integration_offset_);
    windows_.emplace_back(3, GaussianFilter(sigma, kWindowHalfWidth));
  }
}

const std::vector<InterestPoint>& HarrisLaplace::detect(const cv::Mat1f& image, std::size_t limit) {
  pyramid_.build(image);
  candidates_.clear();
  for (int octave = 0; octave < pyramid_.octaves(); ++octave) {
    for (int step = 0; step < options_.steps; ++step) {
      computeCornerness(pyramid_.level(octave, octave * options_.steps + step), step);
      findCorners(octave, step);
    }
  }
  keepStrongest(limit);
  return points_;
}

void HarrisLaplace::computeCornerness(const cv::Mat1f& smoothed, int step) {
  const int width = smoothed.cols;
  const int height = smoothed.rows;
  const float t = static_cast<float>(pyramid_.sigma(step) * pyramid_.sigma(step));
  const float alpha = static_cast<float>(options_.alpha);
  std::vector<GaussianFilter>& window = windows_[step];
  for (GaussianFilter& filter : window) filter.start(width);
  cornerness_.create(height, width);
  moments_.resize(3 * static_cast<std::size_t>(width));
  float *xx = moments_.data(), *xy = xx + width, *yy = xy + width;
  const auto mirror = [height](int y) {
    return cv::borderInterpolate(y, height, cv::BORDER_REFLECT_101);
  };
  const int radius = window[0].radius();
  for (int y = -radius; y < height + radius; ++y) {
    const int here = mirror(y);
    multiplyGradients(smoothed[mirror(here - 1)], smoothed[here], smoothed[mirror(here + 1)], width,
                      window[0].input(), window[1].input(), window[2].input());
    for (GaussianFilter& filter : window) filter.push();
    if (y < radius) continue;
    window[0].pull(xx);
    window[1].pull(xy);
    window[2].pull(yy);
    combineMoments(xx, xy, yy, width, t, alpha, cornerness_[y - radius]);
  }
}

void HarrisLaplace::findCorners(int octave, int step) {
  const float threshold = static_cast<float>(options_.cornerness_threshold);
  is_peak_.resize(cornerness_.cols);
  for (int y = kBorder; y < cornerness_.rows - kBorder; ++y) {
    const float *above = cornerness_[y - 1], *here = cornerness_[y], *below = cornerness_[y + 1];
    markPeaks(above, here, below, cornerness_.cols, threshold, is_peak_.data());
    for (int x = kBorder; x < cornerness_.cols - kBorder; ++x) {
      if (!is_peak_[x]) continue;
      const cv::Point2d corner(x + peakOffset(here[x - 1], here[x], here[x + 1]),
                               y + peakOffset(above[x], here[x], below[x]));
      selectScales(pyramid_.toImage(octave, corner), octave, step, here[x]);
    }
  }
}

/// Makes a candidate of each extremum of the Laplacian over scale that is within an octave of the
/// integration scale. If only extrema at the integration scale itself were accepted, a little noise
/// would remove every other corner.
void HarrisLaplace::selectScales(const cv::Point2d& corner, int octave, int step,
                                 float cornerness) {
  const int integration = octave * options_.steps + step + integration_offset_;
  const int first = std::max(integration - options_.steps, integration_offset_);
  const int last = std::min(integration + options_.steps, pyramid_.scales() - 2);
  double before = laplacian(corner, first - 1);
  double here = laplacian(corner, first);
  for (int scale = first; scale <= last; ++scale) {
    const double after = laplacian(corner, scale + 1);
    if (here >= options_.laplacian_threshold && here > before && here >= after) {
      const double offset = peakOffset(before, here, after);
      const double sigma = pyramid_.sigma(scale) * std::exp2(offset / options_.steps);
      candidates_.push_back({static_cast<float>(corner.x), static_cast<float>(corner.y),
                             static_cast<float>(sigma), cornerness});
    }
    before = here;
    here = after;
  }
}

/// t |L_xx + L_yy| at a point of the image.
double HarrisLaplace::laplacian(const cv::Point2d& place, int scale) const {
  const int octave = pyramid_.octaveOf(scale);
  const cv::Mat1f& image = pyramid_.level(octave, scale);
  const double sigma = pyramid_.sigma(scale - octave * options_.steps);
  return sigma * sigma *
         std::abs(SubpixelLaplacian(pyramid_.toOctave(octave, place), image.size())(image));
}

void HarrisLaplace::keepStrongest(std::size_t limit) {
  const auto order = [](const InterestPoint& p) { return std::tie(p.sigma, p.y, p.x); };
  std::sort(candidates_.begin(), candidates_.end(),
            [&order](const InterestPoint& a, const InterestPoint& b) {
              return a.cornerness != b.cornerness ? a.cornerness > b.cornerness
                                                  : order(a) < order(b);
            });
  points_.clear();
  for (const InterestPoint& candidate : candidates_) {
    if (points_.size() == limit) return;
    const auto same = [&candidate](const InterestPoint& p) { return isSame(p, candidate); };
    if (std::none_of(points_.begin(), points_.end(), same)) points_.push_back(candidate);
  }
}

}  // namespace place_recognition
