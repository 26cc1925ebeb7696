// Cues that place_recognizer skips for some images: ~deadline and ~embedding_rate.

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

using Names = std::vector<std::string>;

/// A recognizer with `deadline:=0.001`, which never leaves time for a second cue.
class HastyRecognizer : public RecognizerNode {
 protected:
  HastyRecognizer() : RecognizerNode("/hasty_recognizer") {}
};

TEST_F(HastyRecognizer, HoldsCuesForWhichThereIsNoTimeAndSaysSo) {
  ASSERT_TRUE(load("cues").success);
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  for (int room = 0; room < 3; ++room) {
    const auto answer = answerTo(answers, drawRoom(room, 77));
    ASSERT_TRUE(answer);
    EXPECT_NE(answer->place, "");
    ASSERT_EQ(answer->held_cues.size(), 1u);
    EXPECT_TRUE(answer->held_cues[0] == "crfh" || answer->held_cues[0] == "colour");
  }
  const auto report = status("Images");
  ASSERT_TRUE(report);
  EXPECT_GE(std::stoi(valueOf(*report, "answers with held cues")), 3);

  reconfigure("deadline", 0);
  const auto answer = answerTo(answers, drawRoom(1, 77));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->held_cues, Names{});
  EXPECT_EQ(answer->place, "room1");
  reconfigure("deadline", 0.001);
}

/// A recognizer with `embedding_rate:=1`.
class SparingRecognizer : public RecognizerNode {
 protected:
  SparingRecognizer() : RecognizerNode("/sparing_recognizer") {}
};

TEST_F(SparingRecognizer, LimitsTheEmbeddingsPerSecond) {
  ASSERT_TRUE(load("network").success);
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  const double start = nextStamp().toSec() + 10;
  for (const double age : {0.0, 0.2, 0.4, 1.0, 1.2}) {
    const ros::Time stamp(start + age);
    camera_.send(drawRoom(1, 77), stamp.toSec());
    const auto answer =
        answers.find([stamp](const auto& message) { return message.header.stamp == stamp; });
    ASSERT_TRUE(answer) << age;
    const bool looks = age == 0.0 || age == 1.0;
    EXPECT_EQ(answer->held_cues, looks ? Names{} : Names{"embedding"}) << age;
  }
  for (int i = 0; i < 12; ++i) nextStamp();
}

}  // namespace
}  // namespace place_recognition
