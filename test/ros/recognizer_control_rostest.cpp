// Switches, thresholds and diagnostics of place_recognizer, and images that cannot be used.

#include <place_recognition/Recognize.h>
#include <std_msgs/String.h>
#include <visualization_msgs/Marker.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

TEST_F(RecognizerNode, UnusableImagesAreReportedAndSurvived) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(0, 1)));
  sensor_msgs::Image bad = toImageMessage(drawRoom(0, 1), headerAt(nextStamp().toSec()));
  bad.height = 65537;
  camera_.send(bad);
  ros::WallDuration(0.2).sleep();
  bad = toImageMessage(drawRoom(0, 1), headerAt(nextStamp().toSec()));
  bad.encoding = "32FC1";
  camera_.send(bad);
  ros::WallDuration(0.2).sleep();
  ASSERT_TRUE(answerTo(answers, drawRoom(2, 1)));
  EXPECT_EQ(answers.messages().size(), 2u);
  const auto report = status("Images");
  ASSERT_TRUE(report);
  EXPECT_GE(std::stoi(valueOf(*report, "unusable")), 2);
  EXPECT_NE(valueOf(*report, "last problem").find("32FC1"), std::string::npos);
}

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

TEST_F(RecognizerNode, SaysWhatIsWrongWithImages) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  cv::Mat grey;
  cv::cvtColor(drawRoom(1, 1), grey, cv::COLOR_BGR2GRAY);
  ASSERT_TRUE(answerTo(answers, grey));
  const auto report = status("Images");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->level, diagnostic_msgs::DiagnosticStatus::WARN);
  EXPECT_NE(report->message.find("grey"), std::string::npos) << report->message;
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  EXPECT_TRUE(eventually([this] {
    const auto now = status("Images");
    return now && now->message.find("grey") == std::string::npos;
  }));
}

TEST_F(RecognizerNode, WarnsOfUnusableImagesBetweenThem) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  sensor_msgs::Image bad = toImageMessage(drawRoom(1, 1), headerAt(nextStamp().toSec()));
  bad.encoding = "32FC1";
  camera_.send(bad);
  const auto warns = [this] {
    const auto report = status("Images");
    return report && report->message.find("unusable images: ") == 0;
  };
  EXPECT_TRUE(eventually(warns));
  EXPECT_TRUE(warns());  // a second later, without another image
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  EXPECT_TRUE(eventually([&] { return !warns(); }));
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

TEST_F(RecognizerNode, CountsWhatItSkipsWhileBusy) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  cv::Mat large;
  cv::resize(drawRoom(1, 1), large, cv::Size(1920, 1440));
  ros::Time last;
  for (int i = 0; i < 100; ++i) {
    last = nextStamp();
    camera_.send(toImageMessage(large, headerAt(last.toSec())));
    ros::WallDuration(0.005).sleep();
  }
  // The newest image is among the answered ones.
  EXPECT_TRUE(answers.find([last](const auto& answer) { return answer.header.stamp == last; }));
  const auto report = status("Images");
  ASSERT_TRUE(report);
  EXPECT_NE(valueOf(*report, "skipped while busy"), "missing");
  EXPECT_NE(valueOf(*report, "answers"), "missing");
}

}  // namespace
}  // namespace place_recognition
