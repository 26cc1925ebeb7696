#include "tuning/light.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "recognition/drawn_run.h"
#include "tuning/thinned_run.h"

namespace place_recognition {
namespace {

TEST(Light, GainsMultiplyTheirChannelsAndSaturate) {
  const cv::Mat image(3, 4, CV_8UC3, cv::Scalar(100, 120, 200));
  const cv::Mat changed = inLight(image, {1.5, 1, 0.5});
  EXPECT_EQ(changed.at<cv::Vec3b>(1, 2), cv::Vec3b(50, 120, 255));
  EXPECT_EQ(image.at<cv::Vec3b>(1, 2), cv::Vec3b(100, 120, 200)) << "the image itself stays";
}

TEST(Light, GreyImagesTakeTheMeanGain) {
  const cv::Mat image(3, 4, CV_8UC1, cv::Scalar(100));
  EXPECT_EQ(inLight(image, {1.2, 0.8, 0.4}).at<uchar>(0, 0), 80);
}

TEST(Light, TheFirstIsThatOfTheRecording) {
  const cv::Mat image = drawRoom(1, 1);
  EXPECT_EQ(inLight(image, lightsToJudge(true).front()).data, image.data);
  EXPECT_EQ(lightsToJudge(false).size(), 1u);
  EXPECT_GT(lightsToJudge(true).size(), 1u);
}

TEST(ThinnedRun, KeepsEveryThirdLabelledFrameOfEachPlace) {
  std::vector<Frame> frames = drawFrames(2, 7);
  frames[1].place.clear();  // the others of room0: 0 2 3 4 5 6, so 0 and 4 are kept
  const auto run = thinOut(opener(frames)(), 3, {});
  std::vector<std::string> kept;
  for (Frame frame; run->next(frame);) kept.push_back(frame.name);
  EXPECT_EQ(kept, (std::vector<std::string>{"frame0", "frame4", "frame7", "frame10", "frame13"}));
}

}  // namespace
}  // namespace place_recognition
