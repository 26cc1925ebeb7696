// Repeatability of the interest points under rotation, scale, blur and brightness on real
// images, beside that of VLFeat's Harris-Laplace with as many points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "features/harris_laplace.h"
#include "features/local_images.h"

#ifdef PLACE_RECOGNITION_HAS_VLFEAT
extern "C" {
#include <vl/covdet.h>
}
#endif

namespace place_recognition {
namespace {

constexpr std::size_t kMaxPoints = 400;
constexpr double kRadius = 3;          ///< of a point's region, in scales
constexpr double kLeastOverlap = 0.6;  ///< intersection over union of corresponding regions
constexpr double kMargin = 12;         ///< pixels at the edge without correspondences

using Points = std::vector<InterestPoint>;
using Detector = std::function<Points(const cv::Mat1b&)>;

Points detectOurs(const cv::Mat1b& image) {
  return HarrisLaplace({2, 4, 5, 0.05, 100, 5}).detect(cv::Mat1f(image), kMaxPoints);
}

#ifdef PLACE_RECOGNITION_HAS_VLFEAT
Points detectVlfeat(const cv::Mat1b& image) {
  const cv::Mat1f pixels = cv::Mat1f(image) / 255;
  VlCovDet* detector = vl_covdet_new(VL_COVDET_METHOD_HARRIS_LAPLACE);
  vl_covdet_set_first_octave(detector, 0);
  vl_covdet_set_peak_threshold(detector, 1e-9);  // all its points
  vl_covdet_put_image(detector, pixels.ptr<float>(), pixels.cols, pixels.rows);
  vl_covdet_detect(detector);
  const auto* features = static_cast<const VlCovDetFeature*>(vl_covdet_get_features(detector));
  Points points;
  for (std::size_t i = 0; i < vl_covdet_get_num_features(detector); ++i) {
    const VlFrameOrientedEllipse& f = features[i].frame;
    const float sigma = std::sqrt(std::abs(f.a11 * f.a22 - f.a12 * f.a21));
    points.push_back({f.x, f.y, sigma, features[i].peakScore});
  }
  vl_covdet_delete(detector);
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.cornerness > b.cornerness; });
  points.resize(std::min(points.size(), kMaxPoints));
  return points;
}
#endif

/// A transformed image and the mapping of its pixels: transformed = map * original.
struct Change {
  std::string name;
  cv::Mat1b image;
  cv::Matx33d map = cv::Matx33d::eye();
};

Change rotated(const cv::Mat1b& image, int degrees) {
  const double c = std::cos(degrees * CV_PI / 180), s = std::sin(degrees * CV_PI / 180);
  const cv::Size size(cvRound(image.cols * std::abs(c) + image.rows * std::abs(s)),
                      cvRound(image.cols * std::abs(s) + image.rows * std::abs(c)));
  const double x = (image.cols - 1) / 2.0, y = (image.rows - 1) / 2.0;
  const cv::Matx33d map(c, s, (size.width - 1) / 2.0 - c * x - s * y,  //
                        -s, c, (size.height - 1) / 2.0 + s * x - c * y, 0, 0, 1);
  cv::Mat1b turned;
  cv::warpAffine(image, turned, map.get_minor<2, 3>(0, 0), size, cv::INTER_CUBIC,
                 cv::BORDER_REPLICATE);
  return {"rotation " + std::to_string(degrees), turned, map};
}

Change shrunk(const cv::Mat1b& image, double factor) {
  cv::Mat1b small;
  cv::resize(image, small, cv::Size(cvRound(image.cols / factor), cvRound(image.rows / factor)), 0,
             0, cv::INTER_AREA);
  const double fx = static_cast<double>(small.cols) / image.cols;
  const double fy = static_cast<double>(small.rows) / image.rows;
  return {"scale " + std::to_string(factor).substr(0, 3),
          small,
          {fx, 0, (fx - 1) / 2, 0, fy, (fy - 1) / 2, 0, 0, 1}};
}

std::vector<Change> changesOf(const cv::Mat1b& image) {
  std::vector<Change> changes;
  for (const int degrees : {10, 30, 45, 60, 90}) changes.push_back(rotated(image, degrees));
  for (const double factor : {1.2, 1.4, 1.6, 2.0}) changes.push_back(shrunk(image, factor));
  for (const int sigma : {1, 2, 3}) {
    cv::Mat1b blurred;
    cv::GaussianBlur(image, blurred, cv::Size(), sigma);
    changes.push_back({"blur " + std::to_string(sigma), blurred});
  }
  for (const double gain : {0.5, 0.7, 1.4}) {
    cv::Mat1b brighter;
    image.convertTo(brighter, -1, gain, gain > 1 ? 10 : 0);
    changes.push_back({"brightness " + std::to_string(gain).substr(0, 3), brighter});
  }
  return changes;
}

/// Intersection over union of two discs.
double overlap(double distance, double a, double b) {
  if (distance >= a + b) return 0;
  double common = CV_PI * std::min(a, b) * std::min(a, b);
  if (distance > std::abs(a - b)) {
    const double x = (distance * distance + a * a - b * b) / (2 * distance);
    const double y = distance - x;
    common = a * a * std::acos(x / a) - x * std::sqrt(std::max(0.0, a * a - x * x)) +
             b * b * std::acos(y / b) - y * std::sqrt(std::max(0.0, b * b - y * y));
  }
  return common / (CV_PI * (a * a + b * b) - common);
}

bool isInside(const cv::Vec3d& p, const cv::Size& size) {
  return p[0] >= kMargin && p[1] >= kMargin && p[0] < size.width - kMargin &&
         p[1] < size.height - kMargin;
}

/// Returns the points of one image that are visible in the other, at their positions there.
Points moved(const Points& points, const cv::Matx33d& map, cv::Size from, cv::Size to) {
  const double scale = std::sqrt(std::abs(cv::determinant(map)));
  Points result;
  for (const InterestPoint& p : points) {
    const cv::Vec3d here(p.x, p.y, 1);
    const cv::Vec3d there = map * here;
    if (!isInside(here, from) || !isInside(there, to)) continue;
    result.push_back({static_cast<float>(there[0]), static_cast<float>(there[1]),
                      static_cast<float>(p.sigma * scale), p.cornerness});
  }
  return result;
}

/// Returns the fraction of points with a partner (one to one, best overlap first), relative to the
/// smaller number of points.
double repeatability(const Points& before, const Points& after, const Change& change,
                     cv::Size size) {
  const Points a = moved(before, change.map, size, change.image.size());
  const Points visible = moved(after, change.map.inv(), change.image.size(), size);
  const Points b = moved(visible, change.map, size, change.image.size());
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double o = overlap(std::hypot(a[i].x - b[j].x, a[i].y - b[j].y), kRadius * a[i].sigma,
                               kRadius * b[j].sigma);
      if (o > kLeastOverlap) pairs.emplace_back(-o, i, j);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> a_taken(a.size()), b_taken(b.size());
  double found = 0;
  for (const auto& [o, i, j] : pairs) {
    if (a_taken[i] || b_taken[j]) continue;
    a_taken[i] = b_taken[j] = true;
    ++found;
  }
  return found / std::max<std::size_t>(1, std::min(a.size(), b.size()));
}

/// Returns the points of all detectors, each truncated to the smallest number that any of them has.
std::vector<Points> detectEqually(const std::vector<Detector>& detectors, const cv::Mat1b& image) {
  std::vector<Points> points;
  std::size_t fewest = kMaxPoints;
  for (const Detector& detect : detectors) {
    points.push_back(detect(image));
    fewest = std::min(fewest, points.back().size());
  }
  for (Points& of_detector : points) of_detector.resize(fewest);
  return points;
}

TEST(Repeatability, OnRealImages) {
  const std::vector<cv::Mat1b> images = realImages(120);
  if (images.empty()) GTEST_SKIP() << "No images: set PLACE_RECOGNITION_TEST_DATA.";
  std::vector<Detector> detectors = {detectOurs};
#ifdef PLACE_RECOGNITION_HAS_VLFEAT
  detectors.push_back(detectVlfeat);
#else
  std::printf("Without VLFeat (libvlfeat-dev) there is nothing to compare with.\n");
#endif
  std::vector<std::vector<double>> table;  // by change and detector
  for (const cv::Mat1b& image : images) {
    const std::vector<Points> before = detectEqually(detectors, image);
    const std::vector<Change> changes = changesOf(image);
    table.resize(changes.size(), std::vector<double>(detectors.size()));
    for (std::size_t c = 0; c < changes.size(); ++c) {
      const std::vector<Points> after = detectEqually(detectors, changes[c].image);
      for (std::size_t k = 0; k < detectors.size(); ++k) {
        table[c][k] += repeatability(before[k], after[k], changes[c], image.size());
      }
    }
  }
  const std::vector<Change> changes = changesOf(images[0]);
  std::vector<double> mean(detectors.size());
  for (std::size_t c = 0; c < table.size(); ++c) {
    std::printf("%-16s", changes[c].name.c_str());
    for (std::size_t k = 0; k < mean.size(); ++k) {
      std::printf("  %.3f", table[c][k] / images.size());
      mean[k] += table[c][k] / images.size() / table.size();
      EXPECT_GE(table[c][0], table[c][k]) << "VLFeat's is better at " << changes[c].name;
    }
    std::printf("\n");
  }
  for (const double m : mean) std::printf("mean %.3f\n", m);
#ifdef PLACE_RECOGNITION_HAS_VLFEAT
  EXPECT_GT(mean[0], 0.88);
#else
  EXPECT_GT(mean[0], 0.8);  // of all our points, including the weaker ones
#endif
}

}  // namespace
}  // namespace place_recognition
