#include "features/embedding.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/version.hpp>
#include <utility>

#include "base/require.h"
#include "features/network_pass.h"
#include "place_recognition/network.h"

namespace place_recognition {
namespace {

/// Scales to this L2 norm. False for a zero vector.
bool normalize(float* values, std::size_t size, double length) {
  double squares = 0;
  for (std::size_t i = 0; i < size; ++i) squares += static_cast<double>(values[i]) * values[i];
  const double norm = std::sqrt(squares) / length;
  if (!std::isfinite(norm) || norm == 0) return false;
  for (std::size_t i = 0; i < size; ++i) values[i] = static_cast<float>(values[i] / norm);
  return true;
}

/// x^p, or 0 if x is negative; x itself for a power of one.
double raised(float x, int power) {
  if (power == 1) return x;
  const double base = std::max(x, 0.0F);
  double result = base;
  for (int i = 1; i < power; ++i) result *= base;
  return result;
}

/// Appends the generalized mean of each value over the height and these columns, scaled to this L2
/// norm.
bool appendMeans(const cv::Mat& output, int begin, int end, int power, double length,
                 std::vector<float>& values) {
  const int height = output.dims == 4 ? output.size[2] : 1;
  const int width = output.dims == 4 ? output.size[3] : 1;
  const std::size_t first = values.size();
  const float* row = output.ptr<float>();
  for (int i = 0; i < output.size[1]; ++i) {
    double sum = 0;
    for (int y = 0; y < height; ++y, row += width) {
      for (int x = begin; x < end; ++x) sum += raised(row[x], power);
    }
    const double mean = sum / (height * (end - begin));
    values.push_back(static_cast<float>(power == 1 ? mean : std::pow(mean, 1.0 / power)));
  }
  return normalize(values.data() + first, values.size() - first, length);
}

std::shared_ptr<NetworkPass> ownPass(EmbeddingOptions options) {
  if (!options.loaded) loadNetwork(options);
  return std::make_shared<NetworkPass>(std::vector<EmbeddingOptions>{options});
}

}  // namespace

EmbeddingExtractor::EmbeddingExtractor(const EmbeddingOptions& options)
    : EmbeddingExtractor(options, ownPass(options)) {
  is_shared_ = false;
}

EmbeddingExtractor::EmbeddingExtractor(const EmbeddingOptions& options,
                                       std::shared_ptr<NetworkPass> shared)
    : stride_(options.stride),
      columns_(options.columns),
      power_(options.power),
      is_shared_(true),
      pass_(std::move(shared)) {
  require(pass_->width(stride_) >= columns_,
          "the output of the network '" + options.network + "' has too few columns");
}

EmbeddingExtractor::~EmbeddingExtractor() = default;

bool EmbeddingExtractor::pool(const cv::Mat& output, std::vector<float>& values) const {
  const int width = pass_->width(stride_);
  values.clear();
  const bool any = appendMeans(output, 0, width, power_, 1, values);
  if (columns_ == 1) return any;
  for (int c = 0; c < columns_; ++c) {
    appendMeans(output, c * width / columns_, (c + 1) * width / columns_, power_,
                1 / std::sqrt(columns_), values);
  }
  return normalize(values.data(), values.size(), 1);
}

void EmbeddingExtractor::extract(const cv::Mat& image, Feature& feature) {
  if (!is_shared_) pass_->forget();
  if (!std::holds_alternative<DenseVector>(feature)) feature = DenseVector();
  std::vector<float>& values = std::get<DenseVector>(feature).values;
  try {
    if (pool(pass_->output(image, stride_), values)) return;
    missing_reason_ = "the network's output for the image is zero";
  } catch (const cv::Exception& e) {
    missing_reason_ = "OpenCV " CV_VERSION " cannot run the network on the image: " + e.err;
  }
  feature = std::monostate();
}

}  // namespace place_recognition
