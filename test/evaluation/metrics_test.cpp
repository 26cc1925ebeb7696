#include "evaluation/metrics.h"

#include <gtest/gtest.h>

#include "report/text_table.h"

namespace place_recognition {
namespace {

TEST(Metrics, ReliabilityCountsByConfidence) {
  const std::vector<ReliabilityBin> bins =
      reliability({0.05, 0.62, 0.68, 1.0}, {false, true, false, true});
  ASSERT_EQ(bins.size(), 10u);
  EXPECT_EQ(bins[0].count, 1u);
  EXPECT_EQ(bins[0].rate, 0);
  EXPECT_EQ(bins[6].count, 2u);
  EXPECT_NEAR(bins[6].confidence, 0.65, 1e-12);
  EXPECT_EQ(bins[6].rate, 0.5);
  EXPECT_EQ(bins[9].count, 1u);
  EXPECT_EQ(bins[9].rate, 1);
  EXPECT_EQ(bins[5].count, 0u);
}

TEST(Metrics, RocAreaIsTheChanceOfTheRightOrder) {
  EXPECT_EQ(rocArea({3, 4}, {1, 2}), 1);
  EXPECT_EQ(rocArea({1, 2}, {3, 4}), 0);
  EXPECT_EQ(rocArea({1, 3}, {2, 0}), 0.75);
  EXPECT_EQ(rocArea({1, 1}, {1}), 0.5);
  EXPECT_EQ(rocArea({}, {1}), 0.5);
}

TEST(Metrics, RocCurveBoundsTheRocArea) {
  const std::vector<double> positive{0.9, 0.8, 0.8, 0.5, 0.2}, negative{0.1, 0.5, 0.8, 0.3};
  const std::vector<RocPoint> points = rocCurve(positive, negative);
  ASSERT_EQ(points.size(), 7u);  // six distinct values
  EXPECT_EQ(points.back().positive_below, 1);
  EXPECT_EQ(points.back().negative_below, 1);
  double area = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    area += (points[i].positive_below - points[i - 1].positive_below) *
            (points[i].negative_below + points[i - 1].negative_below) / 2;
  }
  EXPECT_NEAR(area, rocArea(positive, negative), 1e-12);
}

TEST(Metrics, RiskGrowsAsLessConfidentAnswersAreGiven) {
  const std::vector<RiskPoint> points =
      riskCoverage({0.9, 0.5, 0.7, 0.5}, {true, false, true, true});
  ASSERT_EQ(points.size(), 3u);  // two answers share one confidence
  EXPECT_EQ(points[0].coverage, 0.25);
  EXPECT_EQ(points[0].risk, 0);
  EXPECT_EQ(points[1].coverage, 0.5);
  EXPECT_EQ(points[2].coverage, 1);
  EXPECT_EQ(points[2].risk, 0.25);
  EXPECT_EQ(meanRisk(points), 0.5 * 0.25);
  EXPECT_TRUE(riskCoverage({}, {}).empty());
  EXPECT_EQ(meanRisk({}), 0);
  EXPECT_EQ(riskAt(points, 0.3), points[1].risk);
  EXPECT_EQ(riskAt(points, 1), 0.25);
  EXPECT_EQ(riskAt({}, 0.5), 0);
}

TEST(TextTable, AlignsByCharactersNotBytes) {
  EXPECT_EQ(alignColumns({{"room", "n"}, {"K\xc3\xb6k", "10"}, {"x"}}),
            "room   n\nK\xc3\xb6k   10\nx\n");
}

TEST(TextTable, NamesColumnsAsSpreadsheetsDo) {
  EXPECT_EQ(columnName(0), "A");
  EXPECT_EQ(columnName(25), "Z");
  EXPECT_EQ(columnName(26), "AA");
  EXPECT_EQ(columnName(27 * 26), "AAA");
}

TEST(TextTable, TakesTheLastPartOfAPath) {
  EXPECT_EQ(baseName("/a/b.bag"), "b.bag");
  EXPECT_EQ(baseName("a/b/"), "b");
  EXPECT_EQ(baseName("b"), "b");
  EXPECT_EQ(baseName("/"), "/");
}

}  // namespace
}  // namespace place_recognition
