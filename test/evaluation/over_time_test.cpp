#include "evaluation/over_time.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

/// A drive with one frame per second. Truth and answers are one digit per frame; '-' is unknown.
Evaluation driveOf(const std::string& truth, const std::string& single, const std::string& filtered,
                   const std::string& smoothed) {
  Evaluation evaluation;
  evaluation.places = {"hall", "kitchen", "office"};
  evaluation.model_places = 3;
  evaluation.recordings = {"drive"};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    FrameResult frame;
    frame.stamp = static_cast<double>(i);
    frame.truth = truth[i] - '0';
    frame.known = single[i] != '-';
    frame.place = frame.known ? single[i] - '0' : 0;
    frame.place_over_time = filtered[i] == '-' ? -1 : filtered[i] - '0';
    frame.place_smoothed = smoothed[i] == '-' ? -1 : smoothed[i] - '0';
    evaluation.frames.push_back(frame);
  }
  return evaluation;
}

TEST(OverTime, CountsWrongAndUnknownFramesAndDelays) {
  const auto result = overTime(driveOf("0001110022",    //
                                       "0201-10022",    //
                                       "0000110-00",    //
                                       "0001112-22"));  //
  ASSERT_TRUE(result);
  EXPECT_EQ(result->all.frames, 10u);
  EXPECT_EQ(result->all.single.wrong, 1u);
  EXPECT_EQ(result->all.single.unknown, 1u);
  EXPECT_EQ(result->all.filtered.wrong, 3u);  // one late in the kitchen, two in the office
  EXPECT_EQ(result->all.filtered.unknown, 1u);
  EXPECT_EQ(result->all.smoothed.wrong, 1u);
  EXPECT_EQ(result->all.smoothed.unknown, 1u);
  EXPECT_EQ(result->delays, (std::vector<double>{0, 1}));
  EXPECT_EQ(result->missed, 1u);
  EXPECT_DOUBLE_EQ(result->followedWithin(0.5), 1.0 / 3);
  EXPECT_DOUBLE_EQ(result->followedWithin(2), 2.0 / 3);
}

TEST(OverTime, CountsTheDoorwaysApart) {
  // At one frame per second, a doorway is one frame before a change of room and two from it on.
  const auto result = overTime(driveOf("000011110000",    //
                                       "01122---2212",    //
                                       "011111100221",    //
                                       "222222222222"));  //
  ASSERT_TRUE(result);
  EXPECT_EQ(result->settled.frames, 6u);  // three at the start, one in the kitchen, two at the end
  EXPECT_EQ(result->settled.single.wrong, 4u);
  EXPECT_EQ(result->settled.single.unknown, 1u);
  EXPECT_EQ(result->settled.filtered.wrong, 4u);
  EXPECT_EQ(result->settled.smoothed.wrong, 6u);
}

TEST(OverTime, CountsOnlyChangesBetweenLearnedRooms) {
  Evaluation drive = driveOf("00112200", "00112200", "00110000", "00110000");
  drive.model_places = 2;
  const auto result = overTime(drive);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->delays, (std::vector<double>{0}));  // from the hall to the kitchen
  EXPECT_EQ(result->missed, 0u);
}

TEST(OverTime, ImagesSortedByRoomAreNotADrive) {
  EXPECT_FALSE(overTime(driveOf("000111222", "000111222", "000111222", "000111222")));
}

}  // namespace
}  // namespace place_recognition
