// Measures how the cost of an answer grows with the size of the image, the dimensions and bins of
// its histogram, the support vectors, and the rooms. One core, real images.

#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "features/feature_extractor.h"
#include "learning/binary_svms.h"
#include "learning/support_set.h"
#include "views.h"

namespace place_recognition {
namespace {

/// Times the extraction; reports the number of non-empty bins.
void extract(benchmark::State& state, const CrfhOptions& options, const cv::Mat& image) {
  const auto extractor = makeFeatureExtractor(options);
  Feature feature;
  for (auto _ : state) extractor->extract(image, feature);
  state.counters["bins"] = static_cast<double>(std::get<SparseVector>(feature).size());
}

/// The argument is the height of the image; its width is 4/3 of that.
void imageSize(benchmark::State& state) {
  const auto height = static_cast<int>(state.range(0));
  cv::Mat image;
  cv::resize(Views()[0].image, image, {height * 4 / 3, height}, 0, 0, cv::INTER_AREA);
  extract(state, CrfhOptions(), image);
}

/// The first responses of a list, each at two scales.
void dimensions(benchmark::State& state) {
  const std::vector<std::string> descriptors = {"Lxx", "Lyy", "Lxy", "Lx", "Ly", "L"};
  CrfhOptions options;
  options.descriptors.assign(descriptors.begin(), descriptors.begin() + state.range(0) / 2);
  extract(state, options, Views()[0].image);
}

void bins(benchmark::State& state) {
  CrfhOptions options;
  options.bins = {static_cast<int>(state.range(0))};
  extract(state, options, Views()[0].image);
}

/// Histograms of the first views, extracted on first use.
std::vector<Feature> firstVectors(std::size_t count) {
  static std::vector<Feature> extracted;
  if (extracted.size() < count) {
    const ViewFeatures more =
        extractViews(CrfhOptions(), count - extracted.size(), extracted.size());
    extracted.insert(extracted.end(), more.features.begin(), more.features.end());
  }
  return {extracted.begin(), extracted.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Decision values for the given numbers of vectors and rooms.
void decide(benchmark::State& state, std::size_t vectors, std::size_t rooms) {
  static const Feature frame = extractViews(CrfhOptions(), 1, 40000).features.front();
  BinarySvms machines;
  machines.places = rooms;
  machines.weights.setOnes(static_cast<Eigen::Index>(vectors), static_cast<Eigen::Index>(rooms));
  machines.biases.setZero(static_cast<Eigen::Index>(rooms));
  KernelOptions kernel;
  kernel.gamma = 1;
  const SupportSet set(Kernel(kernel), firstVectors(vectors));
  Eigen::VectorXd values(vectors);
  Eigen::RowVectorXd decision_values;
  for (auto _ : state) {  // as Classifier::decisionValues() does
    set.kernelValues(frame, values);
    decision_values = placeValues(machines, machines.decisionValues(values.transpose()));
  }
}

void supportVectors(benchmark::State& state) {
  decide(state, static_cast<std::size_t>(state.range(0)), Views::kPlaces);
}

void rooms(benchmark::State& state) {
  decide(state, 1000, static_cast<std::size_t>(state.range(0)));
}

BENCHMARK(imageSize)->Arg(120)->Arg(240)->Arg(480)->Arg(960)->Unit(benchmark::kMillisecond);
BENCHMARK(dimensions)->DenseRange(2, 12, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(bins)->Arg(8)->Arg(16)->Arg(28)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond);
BENCHMARK(supportVectors)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(10000)
    ->Arg(20000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(rooms)->Arg(5)->Arg(20)->Arg(50)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace place_recognition
