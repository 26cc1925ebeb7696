#include "recognition/model/place_index.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

TEST(PlaceIndex, FindsEveryNameAndNoOther) {
  const std::vector<std::string> places{"Lift", "corridor", "kitchen", "office"};
  for (int k = 0; k < 4; ++k) EXPECT_EQ(placeIndex(places[static_cast<std::size_t>(k)], places), k);
  for (const char* other : {"", "Kitchen", "attic", "kitche", "kitchen2", "zoo"}) {
    EXPECT_EQ(placeIndex(other, places), -1) << other;
  }
  EXPECT_EQ(placeIndex("kitchen", {}), -1);
}

}  // namespace
}  // namespace place_recognition
