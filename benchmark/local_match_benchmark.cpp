// Compares the local match kernel of one frame with 500 images, 400 descriptors each, with two
// nested loops over float distances and with the peak rate of multiply-add instructions. All three
// are given in products of elements per second. One core.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "learning/support_set.h"
#include "match_peak.h"
#include "views.h"

namespace place_recognition {
namespace {

constexpr std::size_t kImages = 500;
constexpr std::size_t kPeerImages = 5;   // of the slow method; with equal numbers of descriptors
constexpr std::size_t kRealImages = 50;  // each is used several times
constexpr std::size_t kDescriptors = 400;
constexpr std::size_t kDimension = DescriptorSet::kDimension;
constexpr double kProducts = kDescriptors * kDescriptors * kDimension;  // of an image
constexpr double kGamma = 2;

/// Exactly kDescriptors of a set: the first ones, repeated if there are too few.
DescriptorSet filledUp(const DescriptorSet& set, std::size_t first) {
  DescriptorSet filled;
  for (std::size_t i = 0; i < kDescriptors; ++i) {
    const std::uint8_t* row = set.row((first + i) % set.size());
    filled.descriptors.insert(filled.descriptors.end(), row, row + kDimension);
  }
  return filled;
}

struct Setup {
  KernelOptions kernel;
  std::vector<Feature> images;
  Feature frame;

  Setup() {
    kernel.type = "local-match";
    kernel.gamma = kGamma;
    const std::vector<Feature> real = extractViews(LocalFeatureOptions(), kRealImages + 1).features;
    for (std::size_t i = 0; i < kImages; ++i) {
      images.push_back(filledUp(std::get<DescriptorSet>(real[i % kRealImages]), i / kRealImages));
    }
    frame = filledUp(std::get<DescriptorSet>(real.back()), 0);
  }
};

const Setup& setup() {
  static const Setup setup;
  return setup;
}

std::vector<float> toFloats(const Feature& feature) {
  std::vector<float> floats;
  for (const std::uint8_t element : std::get<DescriptorSet>(feature).descriptors) {
    floats.push_back(static_cast<float>(element) / DescriptorSet::kUnit);
  }
  return floats;
}

double meanKernel(const std::vector<float>& squared_distances) {
  double sum = 0;
  for (const float distance : squared_distances) sum += std::exp(-kGamma * distance);
  return sum / static_cast<double>(squared_distances.size());
}

/// Eq. 5.39 and 5.40.
double nestedLoops(const std::vector<float>& x, const std::vector<float>& y) {
  constexpr float kFar = std::numeric_limits<float>::max();
  std::vector<float> x_nearest(kDescriptors, kFar), y_nearest(kDescriptors, kFar);
  for (std::size_t i = 0; i < kDescriptors; ++i) {
    for (std::size_t j = 0; j < kDescriptors; ++j) {
      float distance = 0;
      for (std::size_t k = 0; k < kDimension; ++k) {
        const float difference = x[i * kDimension + k] - y[j * kDimension + k];
        distance += difference * difference;
      }
      x_nearest[i] = std::min(x_nearest[i], distance);
      y_nearest[j] = std::min(y_nearest[j], distance);
    }
  }
  return 0.5 * (meanKernel(x_nearest) + meanKernel(y_nearest));
}

std::vector<double> valuesOfPeer() {
  std::vector<double> values;
  const std::vector<float> frame = toFloats(setup().frame);
  for (std::size_t i = 0; i < kPeerImages; ++i) {
    values.push_back(nestedLoops(frame, toFloats(setup().images[i])));
  }
  return values;
}

benchmark::Counter rate(double products) { return {products, benchmark::Counter::kIsRate}; }

void localMatch(benchmark::State& state) {
  const SupportSet set(Kernel(setup().kernel), setup().images);
  Eigen::VectorXd values(kImages);
  for (auto _ : state) set.kernelValues(setup().frame, values);
  state.counters["products"] = rate(static_cast<double>(state.iterations()) * kImages * kProducts);
  const std::vector<double> expected = valuesOfPeer();
  for (std::size_t i = 0; i < kPeerImages; ++i) {
    if (std::abs(values[i] - expected[i]) > 1e-5) {
      state.SkipWithError("The kernel values differ from the nested loops'.");
    }
  }
}

void nestedFloatLoops(benchmark::State& state) {
  setup();  // preparation, which is not timed
  for (auto _ : state) benchmark::DoNotOptimize(valuesOfPeer());
  state.counters["products"] =
      rate(static_cast<double>(state.iterations()) * kPeerImages * kProducts);
}

void peak(benchmark::State& state) {
  std::int64_t products = 0;
  std::int32_t seed = 1;
  for (auto _ : state) products += multiplyAddAtPeak(1000000, seed);
  benchmark::DoNotOptimize(seed);
  state.counters["products"] = rate(static_cast<double>(products));
}

BENCHMARK(localMatch)->Unit(benchmark::kMillisecond);
BENCHMARK(nestedFloatLoops)->Unit(benchmark::kMillisecond);
BENCHMARK(peak)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace place_recognition
