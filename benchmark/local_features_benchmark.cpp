// Compares Harris-Laplace points with SIFT descriptors with VLFeat's Harris-Laplace points
// described by OpenCV, for the same number of points in the same 640 x 480 image. One core.

#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "features/feature_extractor.h"
#include "sample_image.h"

extern "C" {
#include <vl/covdet.h>
}

namespace place_recognition {
namespace {

constexpr std::size_t kImage = 44;  ///< one with many points

/// At most `limit` oriented Harris-Laplace points of VLFeat, described by OpenCV.
cv::Mat describeWithPeers(const cv::Mat& image, int limit) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::Mat1f pixels;
  grey.convertTo(pixels, CV_32F, 1 / 255.0);
  VlCovDet* detector = vl_covdet_new(VL_COVDET_METHOD_HARRIS_LAPLACE);
  vl_covdet_set_first_octave(detector, 0);
  vl_covdet_set_peak_threshold(detector, 1e-9);
  vl_covdet_put_image(detector, pixels.ptr<float>(), pixels.cols, pixels.rows);
  vl_covdet_detect(detector);
  vl_covdet_extract_orientations(detector);
  const auto* features = static_cast<const VlCovDetFeature*>(vl_covdet_get_features(detector));
  const int count = std::min(limit, static_cast<int>(vl_covdet_get_num_features(detector)));
  std::vector<cv::KeyPoint> keypoints;
  for (int i = 0; i < count; ++i) {
    const VlFrameOrientedEllipse& f = features[i].frame;
    const float sigma = std::sqrt(std::abs(f.a11 * f.a22 - f.a12 * f.a21));
    const int octave = std::max(0, static_cast<int>(std::floor(std::log2(sigma / 1.6f))));
    const int layer = static_cast<int>(std::lround(3 * std::log2(sigma / 1.6f))) - 3 * octave;
    const double degrees = std::atan2(f.a21, f.a11) * 180 / CV_PI;
    keypoints.emplace_back(f.x, f.y, 2 * sigma, static_cast<float>(std::fmod(degrees + 360, 360)),
                           0.0f, octave | (std::max(0, layer) << 8));
  }
  vl_covdet_delete(detector);
  cv::Mat descriptors;
  cv::SIFT::create()->compute(grey, keypoints, descriptors);
  return descriptors;
}

/// The number of points that both find.
int commonCount(const cv::Mat& image) {
  LocalFeatureOptions options;
  options.max_points = describeWithPeers(image, 400).rows;
  Feature feature;
  makeFeatureExtractor(options)->extract(image, feature);
  return static_cast<int>(std::get<DescriptorSet>(feature).size());
}

void harrisLaplaceSift(benchmark::State& state) {
  const cv::Mat image = sampleImage(kImage);
  LocalFeatureOptions options;
  options.max_points = commonCount(image);
  const auto extractor = makeFeatureExtractor(options);
  Feature feature;
  for (auto _ : state) extractor->extract(image, feature);
  state.counters["points"] = static_cast<double>(std::get<DescriptorSet>(feature).size());
}

void vlfeatAndOpenCv(benchmark::State& state) {
  const cv::Mat image = sampleImage(kImage);
  const int count = commonCount(image);
  cv::Mat descriptors;
  for (auto _ : state) descriptors = describeWithPeers(image, count);
  if (descriptors.rows != count) state.SkipWithError("Not the same number of points.");
  state.counters["points"] = descriptors.rows;
}

BENCHMARK(harrisLaplaceSift)->Unit(benchmark::kMillisecond);
BENCHMARK(vlfeatAndOpenCv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  vl_set_num_threads(1);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
