#include "features/local_features.h"

#include <cmath>

#include "base/require.h"
#include "features/grey_levels.h"

namespace place_recognition {

namespace {

HarrisLaplace::Options detectorOptions(const LocalFeatureOptions& options) {
  options.check();
  HarrisLaplace::Options detector;
  detector.sigma = options.sigma;
  detector.steps = options.steps;
  detector.octaves = options.octaves;
  detector.alpha = options.alpha;
  detector.cornerness_threshold = options.cornerness_threshold;
  detector.laplacian_threshold = options.laplacian_threshold;
  return detector;
}

}  // namespace

void LocalFeatureOptions::check(const std::string& key) const {
  requireOption(sigma >= 1 && sigma <= 10, key + ".sigma", sigma, "1 to 10 pixels");
  requireOption(steps >= 2 && steps <= 8 && steps % 2 == 0, key + ".steps", steps, "2, 4, 6 or 8");
  requireOption(octaves >= 1 && octaves <= 10, key + ".octaves", octaves, "1 to 10");
  requireOption(alpha >= 0 && alpha <= 0.2, key + ".alpha", alpha, "0 to 0.2");
  requireOption(cornerness_threshold > 0 && std::isfinite(cornerness_threshold),
                key + ".cornerness_threshold", cornerness_threshold, "a number above 0");
  requireOption(laplacian_threshold >= 0 && std::isfinite(laplacian_threshold),
                key + ".laplacian_threshold", laplacian_threshold, "a number from 0");
  requireOption(max_points >= 1 && max_points <= 20000, key + ".max_points", max_points,
                "1 to 20000");
  requireOption(min_points >= 1 && min_points <= max_points, key + ".min_points", min_points,
                "1 to " + std::to_string(max_points) + " (max_points)");
}

LocalFeatureExtractor::LocalFeatureExtractor(const LocalFeatureOptions& options)
    : options_(options), detector_(detectorOptions(options)) {}

void LocalFeatureExtractor::extract(const cv::Mat& image, Feature& feature) {
  greyLevels(image, converted_).convertTo(image_, CV_32F);
  auto* set = std::get_if<DescriptorSet>(&feature);
  if (!set) set = &feature.emplace<DescriptorSet>();
  set->descriptors.clear();
  const std::size_t limit = options_.max_points * DescriptorSet::kDimension;
  for (const InterestPoint& point : detector_.detect(image_, options_.max_points)) {
    describe(point, set->descriptors);
    if (set->descriptors.size() >= limit) break;
  }
  if (set->descriptors.size() > limit) set->descriptors.resize(limit);

  const int count = static_cast<int>(set->size());
  if (count < options_.min_points) {
    missing_reason_ = "only " + std::to_string(count) + " interest points, " +
                      std::to_string(options_.min_points) + " needed";
    feature = std::monostate();
  }
}

void LocalFeatureExtractor::describe(const InterestPoint& point,
                                     std::vector<std::uint8_t>& descriptors) {
  static_assert(DescriptorSet::kDimension == SiftDescriptor::kDimension);
  const GaussianPyramid& pyramid = detector_.pyramid();
  const int scale = pyramid.nearestScale(point.sigma);
  const int octave = pyramid.octaveOf(scale);
  const cv::Mat1f& level = pyramid.level(octave, scale);
  const cv::Point2f place = pyramid.toOctave(octave, {point.x, point.y});
  const float sigma = point.sigma * std::exp2(static_cast<float>(-octave));
  const auto append = [&](float angle) {
    descriptors.resize(descriptors.size() + DescriptorSet::kDimension);
    sift_.describe(level, place.x, place.y, sigma, angle,
                   &descriptors[descriptors.size() - DescriptorSet::kDimension]);
  };
  if (options_.upright) {
    append(0);
  } else {
    for (const float angle : sift_.orientations(level, place.x, place.y, sigma)) append(angle);
  }
}

}  // namespace place_recognition
