// Suggestions for misspelt names.

#include "base/nearest_name.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

const std::vector<std::string> kKnown = {"model", "lazy", "smoothing", "smoothing_lag", "bag"};

TEST(NearestName, IsTheOneOfTheFewestEdits) {
  EXPECT_EQ(nearestName("modle", kKnown), "model");         // two letters swapped
  EXPECT_EQ(nearestName("smothing", kKnown), "smoothing");  // one missing
  EXPECT_EQ(nearestName("smoothing_lga", kKnown), "smoothing_lag");
  EXPECT_EQ(nearestName("smoothing-lag", kKnown), "smoothing_lag");
  EXPECT_EQ(nearestName("lazyy", kKnown), "lazy");
  EXPECT_EQ(nearestName("Model", kKnown), "model");
  EXPECT_EQ(nearestName("model", kKnown), "model");
}

TEST(NearestName, IsNoneIfNoneIsNear) {
  EXPECT_EQ(nearestName("frame_rate", kKnown), "");
  EXPECT_EQ(nearestName("xy", kKnown), "");  // with every letter replaced, it is another word
  EXPECT_EQ(nearestName("", kKnown), "");
  EXPECT_EQ(nearestName("model", {}), "");
}

}  // namespace
}  // namespace place_recognition
