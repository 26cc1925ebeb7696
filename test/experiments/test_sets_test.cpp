#include "experiments/test_sets.h"

#include <gtest/gtest.h>

#include "experiments/spread.h"
#include "experiments/thesis_places.h"

namespace place_recognition {
namespace {

/// Kitchen and office (places 0 and 1) by day (set 0) and by night (set 1).
SetSamples dayAndNight() { return {{0, 0, 1, 0, 0, 0, 1}, {0, 0, 0, 1, 1, 1, 1}, 2, 2}; }

TEST(SetSamples, TrainsOnOneSetAndTestsOnTheOthers) {
  const Fold split = dayAndNight().split(0);
  EXPECT_EQ(split.train, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(split.test, (std::vector<int>{3, 4, 5, 6}));
}

TEST(SetSamples, PlacesAreNumberedByName) {
  const SetSamples samples = samplesOf(
      {{"day", {{"a.png", "office", 0}, {"b.png", "kitchen", 1}}}, {"night", {{"c", "lift", 0}}}});
  EXPECT_EQ(samples.places, (std::vector<int>{2, 0, 1}));
  EXPECT_EQ(samples.sets, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(samples.place_count, 3);
}

TEST(MeanRate, GivesEachTestSetTheSameWeight) {
  const SetSamples samples = dayAndNight();
  // One of three kitchens and the one office: (1/3 + 1) / 2, not 2 of 4.
  const auto counts = testCounts(samples, {3, 4, 5, 6}, {0, 1, 1, 1});
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_DOUBLE_EQ(meanRate(counts), (1.0 / 3 + 1) / 2);
}

TEST(Spread, IsTheThesisStandardDeviation) {
  // First row of Table 8.4: 52.28 +- 3.10.
  const Spread spread = spreadOf({55.26, 49.08, 52.50});
  EXPECT_NEAR(spread.mean, 52.28, 0.005);
  EXPECT_NEAR(spread.deviation, 3.10, 0.005);
  EXPECT_EQ(plusMinus(spread, 2), "52.28 +- 3.10");
  EXPECT_EQ(spreadOf({5}).deviation, 0);
}

TEST(ThinnedOut, TakesEveryNthImageOfEachPlace) {
  ImageSet set{"day", {}};
  for (int i = 0; i < 7; ++i) {
    set.images.push_back({std::to_string(i), i % 2 == 0 ? "kitchen" : "office", 0.0});
  }
  std::string kept;  // kitchens 0 2 4 6, offices 1 3 5
  for (const LabelledImage& image : thinnedOut(set, 2).images) kept += image.path;
  EXPECT_EQ(kept, "0145");
}

TEST(Thesis, RatesOfTables82And86AverageToWhatItPrints) {
  for (const ThesisFinal* table : {&table82(), &table86()}) {
    for (int training = 0; training < 3; ++training) {
      double sum = 0;
      int count = 0;
      for (const char* room : {"BO", "CR", "EO", "KT", "PR"}) {
        for (const char* set : {"cloudy", "night", "sunny"}) {
          const double rate = table->rate(room, set, training);
          if (rate < 0) continue;
          sum += rate;
          ++count;
        }
      }
      ASSERT_EQ(count, 10);
      EXPECT_NEAR(sum / count, table->average[training], 0.02);
    }
  }
  EXPECT_LT(table82().rate("attic", "night", 0), 0);
}

}  // namespace
}  // namespace place_recognition
