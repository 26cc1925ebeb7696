#include "recognition/frames/cue_extraction.h"

#include <gtest/gtest.h>

#include "recognition/network_options.h"

namespace place_recognition {
namespace {

void expectEqual(const Feature& feature, const Feature& expected) {
  ASSERT_EQ(feature.index(), expected.index());
  if (const auto* dense = std::get_if<DenseVector>(&feature)) {
    EXPECT_EQ(dense->values, std::get<DenseVector>(expected).values);
    return;
  }
  const auto& sparse = std::get<SparseVector>(feature);
  EXPECT_EQ(sparse.indices, std::get<SparseVector>(expected).indices);
  EXPECT_EQ(sparse.values, std::get<SparseVector>(expected).values);
}

TEST(CueExtraction, GivesWhatTheExtractorOfEachCueGives) {
  TrainingOptions options;
  for (CueOptions& cue : options.cues) cue.normalize = "none";
  const cv::Mat image = drawRoom(1, 300);
  std::vector<Feature> features;
  CueExtraction(options, ImageProfile()).extract(image, features);
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    Feature expected;
    makeFeatureExtractor(options.cues[c].feature)->extract(image, expected);
    expectEqual(features[c], expected);
  }
}

TEST(CueExtraction, RunsASharedNetworkOnEachImageAnew) {
  TrainingOptions options = networkOptions();
  options.cues.push_back(options.cues[1]);
  std::get<EmbeddingOptions>(options.cues[2].feature).columns = 3;
  options.cues.push_back(options.cues[1]);
  options.cues[3].normalize = "grey-world";  // another input of the network
  options.cues.push_back(options.cues[1]);
  options.cues[4].feature = SmallNetwork::earlyOptions();
  CueExtraction extraction(options, ImageProfile());
  for (const int seed : {300, 400}) {
    const cv::Mat image = drawRoom(1, seed);
    std::vector<Feature> features;
    extraction.extract(image, features);
    for (const std::size_t c : {1, 2, 4}) {
      Feature expected;
      makeFeatureExtractor(options.cues[c].feature)->extract(image, expected);
      EXPECT_EQ(std::get<DenseVector>(features[c]).values, std::get<DenseVector>(expected).values);
    }
    EXPECT_NE(std::get<DenseVector>(features[3]).values, std::get<DenseVector>(features[1]).values);
  }
}

}  // namespace
}  // namespace place_recognition
