// Randomly damaged ONNX files: each is refused with one line that names it, or is a network whose
// vectors are finite.

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "error_of.h"
#include "features/embedding.h"
#include "features/small_network.h"
#include "place_recognition/network.h"
#include "reliability/damage.h"
#include "rounds.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

/// Returns false if the network is refused.
bool load(EmbeddingOptions& options) {
  const std::string error = errorOf([&] { loadNetwork(options); });
  if (error.empty()) return true;
  EXPECT_NE(error.find(options.network), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  return false;
}

void expectUsable(EmbeddingOptions options) {
  cv::Mat image(20, 24, CV_8UC3);
  cv::theRNG().state = 20;
  cv::randu(image, 0, 256);
  Feature feature;
  EmbeddingExtractor(options).extract(image, feature);
  if (isMissing(feature)) return;
  for (const float value : std::get<DenseVector>(feature).values) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(NetworkDamage, IsRefusedOrUsable) {
  const ScratchFolder folder;
  Damage damage({SmallNetwork::onnx()}, 1);
  int accepted = 0;
  const int count = rounds(2000, 100000);
  for (int i = 0; i < count; ++i) {
    EmbeddingOptions options;
    options.network = folder.write("damaged.onnx", damage.next());
    options.stride = i % 2 == 0 ? 0 : 2;
    if (!load(options)) continue;
    ++accepted;
    expectUsable(options);
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, count);
}

}  // namespace
}  // namespace place_recognition
