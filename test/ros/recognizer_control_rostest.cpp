// Services, switches and thresholds of place_recognizer.

#include <place_recognition/Recognize.h>
#include <std_msgs/String.h>
#include <visualization_msgs/Marker.h>

#include <opencv2/imgcodecs.hpp>

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

TEST_F(RecognizerNode, AnswersOneImageWhenAskedAndPublishesNothing) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  reconfigure("smoothing", 0);
  ASSERT_TRUE(answerTo(answers, drawRoom(0, 1)));
  ASSERT_TRUE(places.find([](const auto& place) { return place.data == "room0"; }));
  answers.clear();
  places.clear();
  const std_msgs::Header header = headerAt(5);
  Recognize raw, compressed, both, none;
  raw.request.image = toImageMessage(drawRoom(2, 1), header);
  compressed.request.compressed.header = header;
  cv::imencode(".png", drawRoom(2, 1), compressed.request.compressed.data);
  both.request.image = raw.request.image;
  both.request.compressed = compressed.request.compressed;
  for (Recognize* call : {&raw, &compressed}) {
    ASSERT_TRUE(ros::service::call(name_ + "/recognize", *call));
    EXPECT_TRUE(call->response.success) << call->response.message;
    EXPECT_EQ(call->response.recognition.place, "room2");
    EXPECT_EQ(call->response.recognition.header.stamp, header.stamp);
    EXPECT_EQ(call->response.recognition.model_name, "three");
  }
  EXPECT_EQ(raw.response.recognition.confidence, compressed.response.recognition.confidence);
  for (Recognize* call : {&both, &none}) {
    ASSERT_TRUE(ros::service::call(name_ + "/recognize", *call));
    EXPECT_FALSE(call->response.success);
    EXPECT_NE(call->response.message.find("one image"), std::string::npos);
  }
  raw.request.image.encoding = "32FC1";
  ASSERT_TRUE(ros::service::call(name_ + "/recognize", raw));
  EXPECT_FALSE(raw.response.success);
  EXPECT_NE(raw.response.message.find("32FC1"), std::string::npos);
  enable(false);
  ASSERT_TRUE(ros::service::call(name_ + "/recognize", compressed));
  EXPECT_TRUE(compressed.response.success);
  enable(true);
  ros::WallDuration(0.3).sleep();
  EXPECT_TRUE(answers.messages().empty());
  for (const auto& place : places.messages()) EXPECT_NE(place.data, "room2");
  reconfigure("smoothing", 0.2);
}

TEST_F(RecognizerNode, ListensOnlyWhileSomebodyListensToIt) {
  EXPECT_TRUE(eventually([this] { return listeners() == 0; }));
  expectListensWith<PlaceRecognition>("/recognition");
  expectListensWith<PlaceRecognition>("/belief");
  expectListensWith<PlaceRecognition>("/smoothed");
  expectListensWith<std_msgs::String>("/place");
  expectListensWith<sensor_msgs::Image>("/debug_image");
  expectListensWith<visualization_msgs::Marker>("/marker");
}

TEST_F(RecognizerNode, CanBeSwitchedOff) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  enable(false);
  EXPECT_TRUE(eventually([this] { return listeners() == 0; }));
  answers.clear();
  camera_.send(drawRoom(1, 2), nextStamp().toSec());
  ros::WallDuration(0.3).sleep();
  EXPECT_TRUE(answers.messages().empty());
  enable(true);
  EXPECT_TRUE(answerTo(answers, drawRoom(1, 3)));
}

TEST_F(RecognizerNode, APauseAndTheSameModelKeepWhatTheStreamHasShown) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  const auto shiftAfter = [&](unsigned frame) {
    EXPECT_TRUE(answerTo(answers, drawRoom(4, frame)));
    const auto report = status("Images");
    return report ? std::stod(valueOf(*report, "shift of the evidence")) : 0;
  };
  trigger("reset");
  for (unsigned frame = 1; frame < 20; ++frame) answerTo(answers, drawRoom(4, frame));
  const double before = shiftAfter(20);
  enable(false);
  enable(true);
  trigger("reload_model");
  EXPECT_GT(shiftAfter(20), 0.7 * before);
  trigger("reset");
  EXPECT_LT(shiftAfter(20), 0.3 * before);
}

TEST_F(RecognizerNode, TakesItsThresholdLive) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  reconfigure("unknown_threshold", 0);
  const auto sure = answerTo(answers, drawRoom(1, 1));
  reconfigure("unknown_threshold", 1);
  const auto unsure = answerTo(answers, drawRoom(1, 1));
  reconfigure("unknown_threshold", -1);
  ASSERT_TRUE(sure && unsure);
  EXPECT_TRUE(sure->known);
  EXPECT_FALSE(unsure->known);
  EXPECT_EQ(unsure->place, "room1");  // still the best guess
}

}  // namespace
}  // namespace place_recognition
