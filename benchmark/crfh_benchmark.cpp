// Compares CRFH with a straightforward OpenCV implementation and with the least work that any
// implementation has to do (crfh_limit.h). One core.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>
#include <vector>

#include "crfh_limit.h"
#include "features/feature_extractor.h"
#include "features/gaussian.h"
#include "sample_image.h"

namespace place_recognition {
namespace {

/// A derivative of one of the planes L, R, G, B.
struct Response {
  char channel;
  int x_order, y_order;
};

/// A set of descriptors, as options and for the OpenCV implementation.
struct Setup {
  const char* name;
  std::vector<std::string> descriptors;
  std::vector<Response> responses;
};

constexpr std::size_t kImage = 83;
const std::vector<double> kScales = {1, 4};
constexpr int kBins = 28;
constexpr int kBorder = 15;
constexpr float kRange = 128;

const std::vector<Setup>& setups() {
  static const std::vector<Setup> setups = {
      {"6", {"Lxx", "Lxy", "Lyy"}, {{'L', 2, 0}, {'L', 1, 1}, {'L', 0, 2}}},
      {"8", {"Lx", "Ly", "Lxx", "Lyy"}, {{'L', 1, 0}, {'L', 0, 1}, {'L', 2, 0}, {'L', 0, 2}}},
      {"12",
       {"Rx", "Rxx", "Gx", "Gxx", "Bx", "Bxx"},
       {{'R', 1, 0}, {'R', 2, 0}, {'G', 1, 0}, {'G', 2, 0}, {'B', 1, 0}, {'B', 2, 0}}}};
  return setups;
}

using Histogram = std::map<std::uint64_t, int>;

int counted(const cv::Mat& image) {
  return (image.rows - 2 * kBorder) * (image.cols - 2 * kBorder);
}

/// Whether both histograms agree except for 0.1 % of the pixels, which lie on bin boundaries.
bool agree(const SparseVector& ours, const Histogram& peers, const cv::Mat& image) {
  Histogram difference = peers;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    difference[ours.indices[i]] -= static_cast<int>(std::lround(ours.values[i] * counted(image)));
  }
  int moved = 0;
  for (const auto& [bin, count] : difference) moved += std::abs(count);
  return moved / 2 <= counted(image) / 1000;
}

/// The straightforward implementation: computes a float image for each descriptor by sepFilter2D,
/// then the bin of each pixel, and sorts.
class OpenCvCrfh {
 public:
  explicit OpenCvCrfh(const Setup& setup) : setup_(setup) {}

  void extract(const cv::Mat& image) {
    planes_.clear();
    bins_.assign(counted(image), 0);
    std::uint64_t weight = 1;
    for (double t : kScales) {
      for (const Response& response : setup_.responses) {
        cv::sepFilter2D(plane(image, response.channel), filtered_, CV_32F,
                        kernel(t, response.x_order), kernel(t, response.y_order));
        accumulate(std::pow(t, 0.5 * (response.x_order + response.y_order)), weight);
        weight *= kBins;
      }
    }
    std::sort(bins_.begin(), bins_.end());
    histogram_.clear();
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      if (i == 0 || bins_[i] != bins_[i - 1]) histogram_.emplace_back(bins_[i], 0);
      ++histogram_.back().second;
    }
  }

  Histogram histogram() const { return {histogram_.begin(), histogram_.end()}; }

 private:
  const cv::Mat& plane(const cv::Mat& image, char channel) {
    static const std::map<char, cv::Matx13f> kMixtures = {
        {'L', {1 / 3.f, 1 / 3.f, 1 / 3.f}}, {'R', {0, 0, 1}}, {'G', {0, 1, 0}}, {'B', {1, 0, 0}}};
    cv::Mat& plane = planes_[channel];
    if (plane.empty()) {
      image.convertTo(pixels_, CV_32F);
      cv::transform(pixels_, plane, kMixtures.at(channel));
    }
    return plane;
  }

  /// Derivatives of the Gaussian by central differences.
  static cv::Mat kernel(double t, int order) {
    const int half = gaussianHalfWidth(t, 3);
    cv::Mat_<double> kernel(1, 2 * half + 3, 0.0);
    for (int x = -half; x <= half; ++x) kernel(0, x + half + 1) = std::exp(-x * x / (2 * t));
    kernel /= cv::sum(kernel)[0];
    static const cv::Matx13d kStencils[] = {{0, 1, 0}, {-0.5, 0, 0.5}, {1, -2, 1}};
    cv::filter2D(kernel, kernel, -1, kStencils[order] * (order == 1 ? -1 : 1), {-1, -1}, 0,
                 cv::BORDER_CONSTANT);
    return kernel;
  }

  void accumulate(double normalization, std::uint64_t weight) {
    const float gain = static_cast<float>(normalization * kBins / (2 * kRange));
    std::size_t i = 0;
    for (int y = kBorder; y < filtered_.rows - kBorder; ++y) {
      const float* row = filtered_.ptr<float>(y);
      for (int x = kBorder; x < filtered_.cols - kBorder; ++x) {
        const int level = static_cast<int>(std::floor(row[x] * gain)) + kBins / 2;
        bins_[i++] += weight * std::clamp(level, 0, kBins - 1);
      }
    }
  }

  const Setup& setup_;
  cv::Mat pixels_, filtered_;
  std::map<char, cv::Mat> planes_;
  std::vector<std::uint64_t> bins_;
  std::vector<std::pair<std::uint64_t, int>> histogram_;
};

/// So many at each scale.
std::vector<double> atEachScale(std::size_t count) {
  std::vector<double> variances;
  for (double t : kScales) variances.insert(variances.end(), count, t);
  return variances;
}

class Limit {
 public:
  explicit Limit(std::size_t images) : limit_(atEachScale(images)) {}

  void extract(const cv::Mat& image) { limit_.compute(image.size()); }

 private:
  CrfhLimit limit_;
};

/// One float image for each response.
struct ResponseLimit : Limit {
  explicit ResponseLimit(const Setup& setup) : Limit(setup.responses.size()) {}
};

/// A stricter limit: one float image for each channel, as if its responses took no further time.
struct SmoothingLimit : Limit {
  explicit SmoothingLimit(const Setup& setup) : Limit(channels(setup)) {}
  static std::size_t channels(const Setup& setup) {
    std::set<char> channels;
    for (const Response& response : setup.responses) channels.insert(response.channel);
    return channels.size();
  }
};

void ours(benchmark::State& state, const Setup& setup, const cv::Mat& image) {
  CrfhOptions options;
  options.descriptors = setup.descriptors;
  options.scales = kScales;
  options.bins = {kBins};
  const auto extractor = makeFeatureExtractor(options);
  Feature feature;
  for (auto _ : state) extractor->extract(image, feature);

  OpenCvCrfh peer(setup);
  peer.extract(image);
  if (!agree(std::get<SparseVector>(feature), peer.histogram(), image)) {
    state.SkipWithError("The histograms differ from the peer's.");
  }
  state.counters["bins"] = static_cast<double>(std::get<SparseVector>(feature).size());
}

template <typename Peer>
void peers(benchmark::State& state, const Setup& setup, const cv::Mat& image) {
  Peer peer(setup);
  for (auto _ : state) peer.extract(image);
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  using namespace place_recognition;
  cv::setNumThreads(1);
  const cv::Mat image = sampleImage(kImage);
  for (const Setup& setup : setups()) {
    const std::string dimensions = std::string(setup.name) + "_dimensions";
    const auto add = [&](const char* name, auto function) {
      benchmark::RegisterBenchmark(("crfh/" + dimensions + "/" + name).c_str(), function, setup,
                                   image)
          ->Unit(benchmark::kMillisecond);
    };
    add("ours", ours);
    add("opencv", peers<OpenCvCrfh>);
    add("limit", peers<ResponseLimit>);
    add("smoothing_limit", peers<SmoothingLimit>);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
