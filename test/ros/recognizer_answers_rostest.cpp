// place_recognizer from outside: images in, answers out. See recognizer.test for the nodes.

#include <std_msgs/String.h>
#include <visualization_msgs/Marker.h>

#include <cmath>
#include <string>

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

class EveryTransport : public RecognizerNode, public testing::WithParamInterface<std::string> {
 protected:
  EveryTransport() : RecognizerNode(GetParam()) {}
};

TEST_P(EveryTransport, AnswersWithTheHeaderOfTheImage) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  for (int room = 0; room < 3; ++room) {
    const auto answer = answerTo(answers, drawRoom(room, 77));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->header.frame_id, "camera_optical");
    EXPECT_EQ(answer->place, "room" + std::to_string(room));
    EXPECT_EQ(answer->model_name, "three");
    EXPECT_EQ(answer->model_version.size(), 8u);
    ASSERT_EQ(answer->places.size(), 3u);
    double sum = 0;
    double largest = 0;
    for (const PlaceScore& score : answer->places) {
      EXPECT_TRUE(std::isfinite(score.margin));
      sum += score.probability;
      largest = std::max(largest, score.probability);
    }
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_EQ(answer->confidence, largest);
    EXPECT_GT(answer->seconds, 0);
  }
  ros::WallDuration(0.3).sleep();
  EXPECT_EQ(answers.messages().size(), 3u);  // one per image, never repeated
}

INSTANTIATE_TEST_SUITE_P(All, EveryTransport,
                         testing::Values("/recognizer", "/compressed_recognizer",
                                         "/nodelet_recognizer"));

TEST_F(RecognizerNode, SmoothedAnswersComeALagLaterWithTheHeadersOfTheirFrames) {
  Inbox<PlaceRecognition> smoothed(node_, name_ + "/smoothed");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  const ros::Time start = nextStamp();
  for (int i = 0; i < 20; ++i) {
    camera_.send(drawRoom(i == 5 ? 0 : 1, 3), (start + ros::Duration(0.1 * i)).toSec());
    ros::WallDuration(0.1).sleep();
  }
  nextStamp();
  const ros::Time stray = start + ros::Duration(0.5);
  const auto answer =
      smoothed.find([&](const auto& message) { return message.header.stamp == stray; });
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->place, "room1");
  EXPECT_EQ(answer->header.frame_id, "camera_optical");
  EXPECT_EQ(answer->model_name, "three");
  for (const PlaceRecognition& message : smoothed.messages()) {
    EXPECT_LE(message.header.stamp, start + ros::Duration(0.95));  // the others still wait
  }
  EXPECT_TRUE(trigger("reset").success);
}

TEST_F(RecognizerNode, BeliefGrowsWithEachFrameOfARoom) {
  Inbox<PlaceRecognition> beliefs(node_, name_ + "/belief");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  ASSERT_TRUE(trigger("reset").success);
  const ros::Time start = nextStamp();
  for (int i = 0; i < 5; ++i) {
    camera_.send(drawRoom(1, 3), (start + ros::Duration(0.1 * i)).toSec());
    const std::size_t come = static_cast<std::size_t>(i) + 1;
    ASSERT_TRUE(eventually([&] { return beliefs.messages().size() == come; }));
  }
  const auto fraction = [](const PlaceRecognition& belief) {
    return belief.places[1].probability * belief.evidence;
  };
  const std::vector<PlaceRecognition> come = beliefs.messages();
  for (std::size_t i = 0; i < come.size(); ++i) {
    EXPECT_EQ(come[i].header.stamp, start + ros::Duration(0.1 * static_cast<double>(i)));
    EXPECT_EQ(come[i].place, "room1");
  }
  EXPECT_GT(fraction(come.back()), fraction(come.front()));
}

TEST_F(RecognizerNode, NamesThePlaceLatchedAndOncePerChange) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  ASSERT_TRUE(trigger("reset").success);
  // The answer over time: a single frame of another room changes nothing.
  double stamp = nextStamp().toSec();
  for (const int room : {1, 1, 1, 1, 0, 1, 1, 1, 2, 2, 2, 2, 2}) {
    camera_.send(drawRoom(room, 3), stamp);
    stamp += 0.1;
    ros::WallDuration(0.2).sleep();
  }
  for (int i = 0; i < 3; ++i) nextStamp();
  const auto named = [](const std::string& name) {
    return [name](const std_msgs::String& place) { return place.data == name; };
  };
  EXPECT_TRUE(places.find(named("room1")));
  EXPECT_TRUE(places.find(named("room2")));
  int first_room = 0, stray = 0;
  for (const std_msgs::String& place : places.messages()) {
    first_room += place.data == "room1";
    stray += place.data == "room0";
  }
  EXPECT_EQ(first_room, 1);
  EXPECT_EQ(stray, 0);
  Inbox<std_msgs::String> latecomer(node_, name_ + "/place");
  EXPECT_TRUE(latecomer.find(named("room2")));
  EXPECT_TRUE(trigger("reset").success);
  EXPECT_TRUE(latecomer.find(named("unknown")));
}

TEST_F(RecognizerNode, MarksThePlaceForRviz) {
  Inbox<visualization_msgs::Marker> markers(node_, name_ + "/marker");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  const ros::Time stamp = nextStamp();
  camera_.send(drawRoom(2, 1), stamp.toSec());
  const auto marker = markers.find([](const visualization_msgs::Marker&) { return true; });
  ASSERT_TRUE(marker);
  EXPECT_EQ(marker->header.stamp, stamp);
  EXPECT_EQ(marker->header.frame_id, "camera_optical");
  EXPECT_EQ(marker->text, "room2");
}

TEST_F(RecognizerNode, DrawsItsAnswer) {
  Inbox<sensor_msgs::Image> images(node_, name_ + "/debug_image");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  const ros::Time stamp = nextStamp();
  camera_.send(drawRoom(0, 1), stamp.toSec());
  const auto image = images.find([](const sensor_msgs::Image&) { return true; });
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.stamp, stamp);
  EXPECT_EQ(image->width, 96u);
  EXPECT_GT(image->height, 72u);
}

TEST_F(RecognizerNode, KeepsToItsRateAndRestartsWhenTimeJumpsBack) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  reconfigure("maximum_rate", 2);
  const double start = nextStamp().toSec() + 10;
  answers.clear();
  const auto play = [&] {
    for (int i = 0; i < 30; ++i) {  // three seconds at 10 Hz, played faster
      camera_.send(drawRoom(1, 1), start + 0.1 * i);
      ros::WallDuration(0.05).sleep();
    }
  };
  play();
  play();  // a looped bag
  reconfigure("maximum_rate", 0);
  EXPECT_TRUE(eventually([&] { return answers.messages().size() >= 12; }, 1));
  EXPECT_NEAR(static_cast<double>(answers.messages().size()), 12, 3);
  EXPECT_TRUE(trigger("reset").success);
}

}  // namespace
}  // namespace place_recognition
