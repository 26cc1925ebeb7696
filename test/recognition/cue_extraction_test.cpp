#include "recognition/frames/cue_extraction.h"

#include <gtest/gtest.h>

#include "recognition/network_options.h"

namespace place_recognition {
namespace {

TEST(CueExtraction, GivesWhatTheExtractorOfEachCueGives) {
  TrainingOptions options;
  for (CueOptions& cue : options.cues) cue.normalize = "none";
  const cv::Mat image = drawRoom(1, 300);
  std::vector<Feature> features;
  CueExtraction(options, ImageProfile()).extract(image, features);
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    Feature expected;
    makeFeatureExtractor(options.cues[c].feature)->extract(image, expected);
    const auto& histogram = std::get<SparseVector>(features[c]);
    EXPECT_EQ(histogram.indices, std::get<SparseVector>(expected).indices);
    EXPECT_EQ(histogram.values, std::get<SparseVector>(expected).values);
  }
}

TEST(CueExtraction, RunsASharedNetworkOnEachImageAnew) {
  TrainingOptions options = networkOptions();
  options.cues.push_back(options.cues[1]);
  std::get<EmbeddingOptions>(options.cues[2].feature).columns = 3;
  options.cues.push_back(options.cues[1]);
  options.cues[3].normalize = "grey-world";  // another input of the network
  CueExtraction extraction(options, ImageProfile());
  for (const int seed : {300, 400}) {
    const cv::Mat image = drawRoom(1, seed);
    std::vector<Feature> features;
    extraction.extract(image, features);
    for (const std::size_t c : {1, 2}) {
      Feature expected;
      makeFeatureExtractor(options.cues[c].feature)->extract(image, expected);
      EXPECT_EQ(std::get<DenseVector>(features[c]).values, std::get<DenseVector>(expected).values);
    }
    EXPECT_NE(std::get<DenseVector>(features[3]).values, std::get<DenseVector>(features[1]).values);
  }
}

}  // namespace
}  // namespace place_recognition
