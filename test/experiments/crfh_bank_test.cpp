#include "experiments/crfh_bank.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "experiments/thesis_histograms.h"
#include "features/feature_extractor.h"
#include "features/feature_images.h"

namespace place_recognition {
namespace {

CrfhOptions histogram(std::vector<std::string> descriptors, std::vector<double> scales, int bins) {
  CrfhOptions options;
  options.descriptors = std::move(descriptors);
  options.scales = std::move(scales);
  options.bins = {bins};
  return options;
}

TEST(CrfhBank, GivesTheHistogramsOfTheExtractor) {
  std::vector<CrfhOptions> histograms;
  for (const ThesisRow& row : table84()) {
    histograms.push_back(histogram(row.descriptors, row.scales, 15));
  }
  // Shared responses with another number of bins, and an index of nearly 64 bits.
  histograms.push_back(histogram({"Lx", "Ly"}, {1, 2, 4}, 35));
  histograms.push_back(histogram({"Lx", "Ly", "Lxx", "Lyy"}, {1, 2, 3, 5}, 15));
  CrfhBank bank(histograms);
  for (const int type : {CV_8UC3, CV_8UC1}) {
    const cv::Mat image = noise(80, 60, type);
    const std::vector<Feature> features = bank.extract(image);
    ASSERT_EQ(features.size(), histograms.size());
    for (std::size_t i = 0; i < histograms.size(); ++i) {
      Feature expected;
      makeFeatureExtractor(histograms[i])->extract(image, expected);
      const auto& histogram = std::get<SparseVector>(expected);
      EXPECT_EQ(std::get<SparseVector>(features[i]).indices, histogram.indices) << i;
      EXPECT_EQ(std::get<SparseVector>(features[i]).values, histogram.values) << i;
    }
  }
}

TEST(CrfhBank, SmallImageHasNone) {
  CrfhBank bank({histogram({"L"}, {1}, 15)});
  EXPECT_TRUE(isMissing(bank.extract(cv::Mat::zeros(20, 30, CV_8UC1))[0]));
}

TEST(Thesis, RowsAverageToWhatItPrints) {
  for (const auto* table : {&table84(), &table85()}) {
    for (const ThesisRow& row : *table) {
      EXPECT_NEAR((row.cloudy + row.night + row.sunny) / 3, row.average, 0.011)
          << row.descriptors[0];
    }
  }
}

}  // namespace
}  // namespace place_recognition
