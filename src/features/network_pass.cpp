#include "features/network_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "base/require.h"
#include "features/network_runner.h"
#include "features/onnx_graph.h"
#include "place_recognition/network.h"

namespace place_recognition {
namespace {

/// The largest central part with the shape of `size`.
cv::Rect centralPart(const cv::Size& image, const cv::Size& size) {
  const double scale = std::min(static_cast<double>(image.width) / size.width,
                                static_cast<double>(image.height) / size.height);
  const int width = std::clamp(static_cast<int>(std::lround(size.width * scale)), 1, image.width);
  const int height =
      std::clamp(static_cast<int>(std::lround(size.height * scale)), 1, image.height);
  return {(image.width - width) / 2, (image.height - height) / 2, width, height};
}

/// Averages over the area of a pixel when shrinking, and interpolates linearly when enlarging.
void scaleTo(const cv::Mat& image, const cv::Size& size, cv::Mat& scaled) {
  const bool shrinks = image.cols >= size.width && image.rows >= size.height;
  cv::resize(image, scaled, size, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
}

}  // namespace

NetworkPass::NetworkPass(const std::vector<EmbeddingOptions>& sharing)
    : crop_(sharing[0].fit == "crop"), channels_(sharing[0].channels == "grey" ? 1 : 3) {
  const EmbeddingOptions& options = sharing[0];
  std::set<int> strides;
  for (const EmbeddingOptions& other : sharing) {
    assert(other.loaded && other.loaded == options.loaded);
    other.check();
    strides.insert(other.stride);
  }
  strides_.assign(strides.begin(), strides.end());
  try {
    const OnnxGraph graph(options.loaded->onnx);
    const NetworkInput input = graph.input();
    require(input.channels == channels_ && input.width > 0 && input.height > 0,
            "it does not accept the images that the options describe");
    runner_ = std::make_unique<NetworkRunner>(graph, strides_);
    for (const EmbeddingOptions& other : sharing) {
      require(runner_->dimension(indexOf(other.stride)) == other.dimension,
              "the size of its output has changed");
    }
    blob_.create(std::vector<int>{1, channels_, input.height, input.width}, CV_32F);
  } catch (const Error& e) {
    throw Error("the network '" + options.network + "' cannot be used: " + e.what() +
                " (OpenCV " CV_VERSION ")");
  }
  for (int c = 0; c < channels_; ++c) {
    const std::size_t i = static_cast<std::size_t>(c);
    sources_[i] = options.channels == "rgb" ? 2 - c : c;
    const double mean = options.mean[options.mean.size() > 1 ? i : 0];
    const double scale = options.scale[options.scale.size() > 1 ? i : 0];
    for (int value = 0; value < 256; ++value) {
      values_[i][static_cast<std::size_t>(value)] = static_cast<float>((value - mean) * scale);
    }
  }
}

NetworkPass::~NetworkPass() = default;

int NetworkPass::width(int stride) const { return runner_->width(indexOf(stride)); }

std::size_t NetworkPass::indexOf(int stride) const {
  const auto found = std::lower_bound(strides_.begin(), strides_.end(), stride);
  assert(found != strides_.end() && *found == stride);
  return static_cast<std::size_t>(found - strides_.begin());
}

const cv::Mat& NetworkPass::output(const cv::Mat& image, int stride) {
  if (!has_run_) {
    fillBlob(image);
    runner_->run(blob_);
    has_run_ = true;
  }
  return runner_->output(indexOf(stride));
}

void NetworkPass::fillBlob(const cv::Mat& image) {
  const cv::Size size(blob_.size[3], blob_.size[2]);
  const cv::Rect part =
      crop_ ? centralPart(image.size(), size) : cv::Rect(0, 0, image.cols, image.rows);
  scaleTo(image(part), size, scaled_);
  if (channels_ == 1 && scaled_.channels() == 3) {
    cv::cvtColor(scaled_, grey_, cv::COLOR_BGR2GRAY);
  } else {
    grey_ = scaled_;
  }
  // A grey image serves as every channel.
  const int step = grey_.channels();
  auto* next = blob_.ptr<float>();
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    const int source = step == 1 ? 0 : sources_[c];
    for (int y = 0; y < grey_.rows; ++y) {
      const std::uint8_t* pixel = grey_.ptr<std::uint8_t>(y) + source;
      for (int x = 0; x < grey_.cols; ++x, pixel += step) *next++ = values_[c][*pixel];
    }
  }
}

}  // namespace place_recognition
