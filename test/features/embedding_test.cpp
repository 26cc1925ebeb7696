#include "features/embedding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "features/feature_images.h"
#include "features/network_pass.h"
#include "features/onnx_graph.h"
#include "features/small_network.h"
#include "place_recognition/error.h"
#include "place_recognition/network.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

TEST(Embedding, IsAUnitVectorOfTheNetworksDimension) {
  const std::vector<float> values = extractDense(noise(40, 30), SmallNetwork::options());
  ASSERT_EQ(values.size(), SmallNetwork::kDimension);
  double squares = 0;
  for (const float value : values) squares += static_cast<double>(value) * value;
  EXPECT_NEAR(squares, 1, 1e-6);
}

TEST(Embedding, TakesWhatTheLayerNeedsAndNoMore) {
  const ScratchFolder folder;
  EmbeddingOptions options;
  options.network = folder.write("a.onnx", SmallNetwork::onnx());
  loadNetwork(options);
  const Network whole = *options.loaded;
  EXPECT_EQ(options.dimension, SmallNetwork::kDimension);
  options.layer = "rectified";
  loadNetwork(options);
  const Network part = *options.loaded;
  EXPECT_EQ(options.dimension, SmallNetwork::kEarlyDimension);
  EXPECT_LT(part.onnx.size(), whole.onnx.size());
  EXPECT_EQ(OnnxGraph(part.onnx).layers(), 2u);
  EXPECT_EQ(part.sha256, whole.sha256);
  options.layer = "r1";  // the same layer, by the name of its output
  loadNetwork(options);
  EXPECT_EQ(options.loaded->onnx, part.onnx);
}

TEST(Embedding, OfAStrideIsThatOfTheLastLayerWithIt) {
  const ScratchFolder folder;
  EmbeddingOptions by_name;
  by_name.network = folder.write("a.onnx", SmallNetwork::onnx());
  EmbeddingOptions by_stride = by_name;
  by_name.layer = "rectified";
  by_stride.stride = 2;
  for (const int power : {1, 3}) {
    by_name.power = by_stride.power = power;
    EXPECT_EQ(extractDense(noise(16, 16), by_stride), extractDense(noise(16, 16), by_name));
  }
  EmbeddingOptions early = by_stride;
  loadNetwork(early);
  EXPECT_EQ(early.dimension, SmallNetwork::kEarlyDimension);
  EmbeddingOptions whole = by_stride;
  whole.stride = 0;
  loadNetwork(whole);
  EXPECT_EQ(early.loaded->onnx, whole.loaded->onnx);  // so that a model stores it once
  by_stride.stride = 4;
  by_name.layer = "";
  EXPECT_EQ(extractDense(noise(16, 16), by_stride), extractDense(noise(16, 16), by_name));
}

TEST(Embedding, OfAHighPowerTendsToTheLargestValues) {
  EmbeddingOptions options = SmallNetwork::earlyOptions();
  NetworkPass pass({options});
  const cv::Mat output = pass.output(noise(16, 16), 2).reshape(1, SmallNetwork::kEarlyDimension);
  cv::Mat largest;
  cv::reduce(output, largest, 1, cv::REDUCE_MAX);
  double before = 0;
  for (const int power : {1, 4, 8}) {
    options.power = power;
    const std::vector<float> values = extractDense(noise(16, 16), options);
    double product = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      product += static_cast<double>(values[i]) * largest.at<float>(static_cast<int>(i));
    }
    const double likeness = product / cv::norm(largest);
    EXPECT_GT(likeness, before);
    before = likeness;
  }
  EXPECT_GT(before, 0.999);
}

TEST(Embedding, HasAPartForTheWholeAndForEachColumn) {
  const ScratchFolder folder;
  EmbeddingOptions options;
  options.network = folder.write("a.onnx", SmallNetwork::onnx());
  const std::vector<float> whole = extractDense(noise(16, 16), options);
  options.columns = 4;  // each of one value in a row of the output
  const std::vector<float> parts = extractDense(noise(16, 16), options);
  ASSERT_EQ(parts.size(), 5 * SmallNetwork::kDimension);
  for (std::size_t i = 0; i < SmallNetwork::kDimension; ++i) {
    EXPECT_NEAR(parts[i] * std::sqrt(2.0), whole[i], 1e-6);
  }
  for (std::size_t part = 0; part < 5; ++part) {
    double squares = 0;
    for (std::size_t i = 0; i < SmallNetwork::kDimension; ++i) {
      const float value = parts[part * SmallNetwork::kDimension + i];
      squares += static_cast<double>(value) * value;
    }
    EXPECT_NEAR(squares, part == 0 ? 1 / 2.0 : 1 / 8.0, 1e-6);
  }
}

TEST(Embedding, OfAGreyImageIsThatOfTheSameImageInThreeChannels) {
  const cv::Mat grey = noise(50, 40, CV_8UC1);
  cv::Mat three;
  cv::merge(std::vector<cv::Mat>{grey, grey, grey}, three);
  EXPECT_EQ(extractDense(grey, SmallNetwork::options()),
            extractDense(three, SmallNetwork::options()));
}

TEST(Embedding, CropLooksAtTheCentreAlone) {
  EmbeddingOptions options = SmallNetwork::options();
  options.fit = "crop";
  cv::Mat image = noise(64, 32);
  const std::vector<float> expected = extractDense(image, options);
  image.colRange(0, 16) = cv::Scalar::all(0);
  image.colRange(48, 64) = cv::Scalar::all(255);
  EXPECT_EQ(extractDense(image, options), expected);
  EXPECT_EQ(extractDense(image.colRange(16, 48).clone(), SmallNetwork::options()), expected);
}

TEST(Embedding, OfTheSmallestImageExists) {
  EXPECT_EQ(extractDense(noise(1, 1), SmallNetwork::options()).size(), SmallNetwork::kDimension);
}

TEST(NetworkPass, RunsTheNetworkOnceUntilItForgets) {
  NetworkPass pass({SmallNetwork::options(), SmallNetwork::earlyOptions()});
  const cv::Mat first = pass.output(noise(16, 16), 0).clone();
  const cv::Mat early = pass.output(noise(16, 16), 2).clone();
  const cv::Mat other = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(7));
  EXPECT_EQ(cv::norm(pass.output(other, 0), first, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(pass.output(other, 2), early, cv::NORM_INF), 0);
  pass.forget();
  EXPECT_GT(cv::norm(pass.output(other, 0), first, cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(pass.output(other, 2), early, cv::NORM_INF), 0);
}

TEST(EmbeddingOptions, RefuseWhatIsOutOfRange) {
  const auto refuses = [](void (*change)(EmbeddingOptions&)) {
    EmbeddingOptions options = SmallNetwork::options();
    options.check();
    change(options);
    EXPECT_THROW(options.check(), Error);
  };
  refuses([](EmbeddingOptions& o) { o.network = ""; });
  refuses([](EmbeddingOptions& o) { o.network = "two words"; });
  refuses([](EmbeddingOptions& o) { o.width = 15; });
  refuses([](EmbeddingOptions& o) { o.height = 1025; });
  refuses([](EmbeddingOptions& o) { o.height = -1; });
  for (const int stride : {-2, 1, 3, 128}) {
    EmbeddingOptions options = SmallNetwork::options();
    options.stride = stride;
    EXPECT_THROW(options.check(), Error) << stride;
  }
  refuses([](EmbeddingOptions& o) { o.power = 0; });
  refuses([](EmbeddingOptions& o) { o.power = 9; });
  refuses([](EmbeddingOptions& o) { o.columns = 0; });
  refuses([](EmbeddingOptions& o) { o.columns = 17; });
  refuses([](EmbeddingOptions& o) { o.fit = "pad"; });
  refuses([](EmbeddingOptions& o) { o.channels = "RGB"; });
  refuses([](EmbeddingOptions& o) { o.mean = {}; });
  refuses([](EmbeddingOptions& o) { o.mean = {1, 2}; });
  refuses([](EmbeddingOptions& o) { o.mean = {1001}; });
  refuses([](EmbeddingOptions& o) { o.scale = {0}; });
  refuses([](EmbeddingOptions& o) {
    o.channels = "grey";
    o.scale = {1, 1, 1};
  });
}

TEST(EmbeddingExtractor, TakesNoNetworkOfAnotherSizeThanTheModels) {
  EmbeddingOptions options = SmallNetwork::options();
  ++options.dimension;
  EXPECT_THROW(EmbeddingExtractor{options}, Error);
  options = SmallNetwork::options();
  options.columns = 8;
  EXPECT_THROW(EmbeddingExtractor{options}, Error);
}

}  // namespace
}  // namespace place_recognition
