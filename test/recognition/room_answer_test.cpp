#include "recognition/over_time/room_answer.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

FilteredAnswer answerOf(int place, const Eigen::RowVector4d& probabilities) {
  FilteredAnswer answer;
  answer.place = place;
  answer.probabilities = probabilities;
  return answer;
}

TEST(RoomAnswer, IsConditionalOnTheRooms) {
  const RoomAnswer answer = roomAnswer(answerOf(-1, {0.125, 0.25, 0.125, 0.5}));
  EXPECT_EQ(answer.place, 1);
  EXPECT_FALSE(answer.known);
  EXPECT_EQ(answer.confidence, 0.5);
  EXPECT_EQ(answer.evidence, 0.5);
  EXPECT_EQ(answer.probabilities, Eigen::RowVector3d(0.25, 0.5, 0.25));
  EXPECT_TRUE(roomAnswer(answerOf(2, {0, 0, 1, 0})).known);
}

TEST(RoomAnswer, IsAnyRoomWithoutEvidence) {
  const RoomAnswer answer = roomAnswer(answerOf(-1, {0, 0, 0, 1}));
  EXPECT_EQ(answer.evidence, 0);
  EXPECT_EQ(answer.probabilities, Eigen::RowVector3d::Constant(1.0 / 3));
  EXPECT_EQ(answer.confidence, answer.probabilities[answer.place]);
}

TEST(RoomAnswer, HasProbabilitiesForTheFaintestEvidence) {
  const RoomAnswer answer = roomAnswer(answerOf(-1, {0, 3e-300, 1e-300, 1}));
  EXPECT_EQ(answer.place, 1);
  EXPECT_NEAR(answer.confidence, 0.75, 1e-12);
  EXPECT_NEAR(answer.probabilities.sum(), 1, 1e-12);
}

}  // namespace
}  // namespace place_recognition
