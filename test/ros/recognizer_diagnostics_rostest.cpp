// What place_recognizer reports about its images, also those that cannot be used.

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
