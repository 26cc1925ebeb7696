#include "recognition/frames/mirror_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Maximum number of images of a run to average.
constexpr int kImages = 20;
/// Side of the image for the coarse search, px.
constexpr int kCoarseSide = 160;
/// Points on a circle; those outside of the image are ignored.
constexpr int kPoints = 120;
/// Maximum distance of the rim's centre from the middle of the image, and range of its radius, in
/// shorter sides.
constexpr double kMaxOffset = 0.1;
constexpr double kMinRadius = 0.25;
constexpr double kMaxRadius = 0.62;
/// Minimum step of mean brightness at a rim, in grey levels, and at an inner circle.
constexpr double kMinRimStep = 12;
constexpr double kMinInnerStep = 6;
/// Radius of the inner circle in radii of the rim: the default if it is not visible, and its
/// limits.
constexpr double kUnseenInner = 0.25;
constexpr double kMinInner = 0.08;
constexpr double kMaxInner = 0.6;

struct Circle {
  cv::Point2d center;
  double radius = 0;
  double step = 0;  ///< of the mean brightness, from outside to inside
};

class CircleSearch {
 public:
  /// `grey`: CV_32FC1.
  explicit CircleSearch(cv::Mat grey) : grey_(std::move(grey)) {
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2 * CV_PI * i / kPoints;
      directions_[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
  }

  /// The circle with the largest step times `sign`, among centres within `reach` px of `middle` and
  /// radii from `least` to `most`, px.
  Circle strongest(cv::Point2d middle, double reach, double least, double most, double sign) const {
    Circle best;
    for (double y = middle.y - reach; y <= middle.y + reach; ++y) {
      for (double x = middle.x - reach; x <= middle.x + reach; ++x) {
        const Circle here = strongestAround({x, y}, least, most, sign);
        if (sign * here.step > sign * best.step) best = here;
      }
    }
    return best;
  }

 private:
  Circle strongestAround(cv::Point2d center, double least, double most, double sign) const {
    Circle best;
    // Means along circles one pixel apart; a step is the difference between the two inside a radius
    // and the two outside.
    std::array<double, 4> means{};
    int known = 0;
    for (double radius = least - 1.5; radius <= most + 1.5; ++radius) {
      std::rotate(means.begin(), means.begin() + 1, means.end());
      known = meanAlong(center, radius, means.back()) ? known + 1 : 0;
      if (known < 4) continue;
      const double step = (means[0] + means[1] - means[2] - means[3]) / 2;
      if (sign * step > sign * best.step) best = {center, radius - 1.5, step};
    }
    return best;
  }

  /// False if less than half of the circle is in the image.
  bool meanAlong(cv::Point2d center, double radius, double& mean) const {
    double sum = 0;
    int inside = 0;
    for (const cv::Point2d& direction : directions_) {
      const cv::Point2d at = center + radius * direction;
      const int x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
      if (x < 0 || y < 0 || x >= grey_.cols || y >= grey_.rows) continue;
      sum += grey_.at<float>(y, x);
      ++inside;
    }
    mean = inside > 0 ? sum / inside : 0;
    return 2 * inside >= kPoints;
  }

  cv::Mat grey_;
  std::array<cv::Point2d, kPoints> directions_;
};

cv::Mat greyOf(const cv::Mat& image) {
  cv::Mat grey = image;
  if (image.channels() == 3) cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::Mat result;
  grey.convertTo(result, CV_32F);
  return result;
}

/// The mean of those first images of a run that have the size of the first one; empty if there are
/// none.
cv::Mat meanImage(Recording& recording) {
  cv::Mat sum;
  int count = 0;
  for (Frame frame; count < kImages && recording.next(frame);) {
    if (frame.image.empty()) continue;
    const cv::Mat grey = greyOf(frame.image);
    if (sum.empty()) sum = cv::Mat::zeros(grey.size(), CV_32F);
    if (grey.size() != sum.size()) continue;
    sum += grey;
    ++count;
  }
  return count > 0 ? cv::Mat(sum / count) : cv::Mat();
}

PanoramaOptions requireMirror(const cv::Mat& image, const std::string& name) {
  if (const std::optional<MirrorRing> ring = findMirror(image)) {
    return optionsOf(*ring, image.size());
  }
  throw Error("No mirror of an omnidirectional camera is found in the images of " + name +
              "; give image.panorama.mirror=given "
              "with center_x, center_y, inner and outer, or none for an ordinary camera.");
}

}  // namespace

std::optional<MirrorRing> findMirror(const cv::Mat& image) {
  const double side = std::min(image.cols, image.rows);
  if (side < 32) return std::nullopt;
  const cv::Mat fine = image.depth() == CV_32F ? image : greyOf(image);
  const double factor = std::max(1.0, side / kCoarseSide);
  cv::Mat coarse;
  cv::resize(fine, coarse, {}, 1 / factor, 1 / factor, cv::INTER_AREA);
  const double coarse_side = std::min(coarse.cols, coarse.rows);
  const Circle rough = CircleSearch(coarse).strongest(
      {coarse.cols / 2.0, coarse.rows / 2.0}, kMaxOffset * coarse_side, kMinRadius * coarse_side,
      kMaxRadius * coarse_side, 1);
  if (rough.step < kMinRimStep) return std::nullopt;
  const CircleSearch search(fine);
  const double reach = std::ceil(factor);
  const Circle rim = search.strongest(factor * rough.center, reach, factor * rough.radius - reach,
                                      factor * rough.radius + reach, 1);
  if (rim.step <= 0) return std::nullopt;
  const Circle inner =
      search.strongest(rim.center, 0, kMinInner * rim.radius, kMaxInner * rim.radius, -1);
  const bool seen = -inner.step >= kMinInnerStep;
  return MirrorRing{rim.center, seen ? inner.radius : kUnseenInner * rim.radius, rim.radius};
}

TrainingOptions withMirror(TrainingOptions options,
                           const std::vector<RecordingOpener>& recordings) {
  if (options.image.panorama.mirror != "found") return options;
  std::string name = "the runs";
  for (const RecordingOpener& open : recordings) {
    const std::unique_ptr<Recording> recording = open();
    name = recording->name();
    const cv::Mat mean = meanImage(*recording);
    if (mean.empty()) continue;
    options.image.panorama = requireMirror(mean, name);
    return options;
  }
  throw Error("There is no image in " + name + " to search for a mirror.");
}

TrainingOptions withMirror(TrainingOptions options, const cv::Mat& image, const std::string& name) {
  if (options.image.panorama.mirror == "found") {
    options.image.panorama = requireMirror(image, name);
  }
  return options;
}

}  // namespace place_recognition
