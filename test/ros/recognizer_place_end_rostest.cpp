// When the place of place_recognizer becomes unknown: without images, or with images that show
// nothing. And that it does not stay with stamps that stand still.

#include <std_msgs/String.h>

#include <string>

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

/// A recognizer whose `~image_timeout` is one second.
class ImpatientRecognizerNode : public RecognizerNode {
 protected:
  ImpatientRecognizerNode() : RecognizerNode("/impatient_recognizer") {}

  bool placeBecomes(Inbox<std_msgs::String>& places, const std::string& place) {
    return places.find([&](const auto& message) { return message.data == place; }).has_value();
  }

  /// Shows a room until `~place` names it.
  bool showRoom1(Inbox<std_msgs::String>& places) {
    if (!eventually([this] { return listeners() > 0; })) return false;
    for (unsigned i = 0; i < 3; ++i) {
      camera_.send(drawRoom(1, i), nextStamp().toSec());
      ros::WallDuration(0.1).sleep();
    }
    return placeBecomes(places, "room1");
  }
};

TEST_F(ImpatientRecognizerNode, ThePlaceEndsWithItsCamera) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(showRoom1(places));
  places.clear();
  EXPECT_TRUE(placeBecomes(places, "unknown"));
  places.clear();
  EXPECT_TRUE(showRoom1(places));
}

TEST_F(ImpatientRecognizerNode, ThePlaceFollowsACameraWhoseStampsStandStill) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  const double stamp = nextStamp().toSec();
  for (unsigned i = 0; i < 60; ++i) {
    camera_.send(drawRoom(i < 20 ? 1 : 2, i), stamp);
    ros::WallDuration(0.1).sleep();
    if (i == 19) {
      ASSERT_TRUE(placeBecomes(places, "room1"));
    }
  }
  EXPECT_TRUE(placeBecomes(places, "room2"));
}

TEST_F(ImpatientRecognizerNode, ThePlaceEndsWhereImagesCannotBeUsed) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(showRoom1(places));
  places.clear();
  for (int i = 0; i < 20; ++i) {
    sensor_msgs::Image bad = toImageMessage(drawRoom(1, 1), headerAt(nextStamp().toSec()));
    bad.encoding = "32FC1";
    camera_.send(bad);
    ros::WallDuration(0.1).sleep();
  }
  EXPECT_TRUE(placeBecomes(places, "unknown"));
}

TEST_F(ImpatientRecognizerNode, ThePlaceEndsWhenTheLensIsCovered) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  Inbox<PlaceRecognition> beliefs(node_, name_ + "/belief");
  ASSERT_TRUE(showRoom1(places));
  places.clear();
  const ros::Time covered = nextStamp();
  const cv::Mat black = drawRoom(1, 1) * 0;
  for (int i = 0; i < 150 && places.messages().empty(); ++i) {
    camera_.send(black, nextStamp().toSec());
    ros::WallDuration(0.1).sleep();
  }
  EXPECT_TRUE(placeBecomes(places, "unknown"));
  for (const PlaceRecognition& belief : beliefs.messages()) {
    EXPECT_LT(belief.header.stamp, covered);
  }
  EXPECT_TRUE(showRoom1(places));
}

/// Images that `~maximum_rate` leaves out say nothing about a camera that shows nothing.
TEST_F(ImpatientRecognizerNode, ThePlaceEndsThoughSomeImagesAreLeftOut) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  sensor_msgs::Image black = toImageMessage(drawRoom(1, 1) * 0, headerAt(0));
  sensor_msgs::Image strange = toImageMessage(drawRoom(1, 1), headerAt(0));
  strange.encoding = "32FC1";
  for (sensor_msgs::Image bad : {black, strange}) {
    reconfigure("maximum_rate", 0);
    places.clear();
    ASSERT_TRUE(showRoom1(places)) << bad.encoding;
    places.clear();
    reconfigure("maximum_rate", 0.5);  // every second image, by their stamps
    for (int i = 0; i < 60 && places.messages().empty(); ++i) {
      bad.header.stamp = nextStamp();
      camera_.send(bad);
      ros::WallDuration(0.1).sleep();
    }
    EXPECT_FALSE(places.messages().empty()) << bad.encoding;
  }
  reconfigure("maximum_rate", 0);
}

TEST_F(RecognizerNode, KeepsThePlaceBetweenTheImagesThatItsRateAdmits) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  camera_.send(drawRoom(1, 1), nextStamp().toSec());
  ASSERT_TRUE(places.find([](const auto& place) { return place.data == "room1"; }));
  places.clear();
  reconfigure("maximum_rate", 1e-3);
  for (int i = 0; i < 65; ++i) {  // longer than `~image_timeout`
    camera_.send(drawRoom(1, 1), nextStamp().toSec());
    ros::WallDuration(0.1).sleep();
  }
  EXPECT_TRUE(places.messages().empty());
  reconfigure("maximum_rate", 0);
}

TEST_F(RecognizerNode, AnswersUnknownToABlackFrameWithoutSmoothing) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  Inbox<PlaceRecognition> beliefs(node_, name_ + "/belief");
  reconfigure("smoothing", 0);
  EXPECT_TRUE(answerTo(beliefs, drawRoom(1, 1)));
  const auto belief = answerTo(beliefs, drawRoom(1, 1) * 0);
  reconfigure("smoothing", 0.2);
  ASSERT_TRUE(belief);
  EXPECT_FALSE(belief->known);
  EXPECT_EQ(places.messages().back().data, "unknown");  // published before the belief
}

TEST_F(ImpatientRecognizerNode, NobodyIsToldAnOldPlace) {
  {
    Inbox<std_msgs::String> places(node_, name_ + "/place");
    ASSERT_TRUE(showRoom1(places));
    places.clear();
    enable(false);
    EXPECT_TRUE(placeBecomes(places, "unknown"));
    enable(true);
    ASSERT_TRUE(showRoom1(places));
  }
  ASSERT_TRUE(eventually([this] { return listeners() == 0; }));
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(eventually([&] { return !places.messages().empty(); }));
  EXPECT_EQ(places.messages().front().data, "unknown");
}

}  // namespace
}  // namespace place_recognition
