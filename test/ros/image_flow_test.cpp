// From the subscription to the worker: the newest image, and the rate limit. Also the debug image.

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <thread>

#include "base/rate_limit.h"
#include "ros/recognizer/debug_image.h"
#include "ros/recognizer/work_queue.h"

namespace place_recognition {
namespace {

ImageMessage numbered(std::uint32_t number) {
  const auto message = boost::make_shared<sensor_msgs::Image>();
  message->header.seq = number;
  return ImageMessage(sensor_msgs::ImageConstPtr(message));
}

std::uint32_t numberOf(const Work& work) {
  return std::visit([](const auto& item) { return item.message.header().seq; }, work);
}

TEST(WorkQueue, KeepsQuestionsAndHandsThemOutFirst) {
  WorkQueue queue;
  queue.put(numbered(1));
  std::future<PlaceRecognition> first = queue.ask(numbered(2));
  std::future<PlaceRecognition> second = queue.ask(numbered(3));
  std::optional<Work> work = queue.take();
  EXPECT_EQ(numberOf(*work), 2u);
  PlaceRecognition answer;
  answer.place = "kitchen";
  std::get<Question>(*work).answer.set_value(answer);
  EXPECT_EQ(first.get().place, "kitchen");
  EXPECT_EQ(numberOf(*queue.take()), 3u);
  EXPECT_THROW(second.get(), std::future_error);  // the worker ended without an answer
  EXPECT_EQ(numberOf(*queue.take()), 1u);
}

TEST(WorkQueue, LeavesNobodyWaitingWhenItIsClosed) {
  WorkQueue queue;
  std::future<PlaceRecognition> before = queue.ask(numbered(1));
  queue.close();
  std::future<PlaceRecognition> after = queue.ask(numbered(2));
  EXPECT_THROW(before.get(), std::future_error);
  EXPECT_THROW(after.get(), std::future_error);
}

TEST(WorkQueue, ReplacesTheOneThatWaits) {
  WorkQueue queue;
  EXPECT_TRUE(queue.put(numbered(1)));
  EXPECT_FALSE(queue.put(numbered(2)));
  EXPECT_EQ(numberOf(*queue.take()), 2u);
  EXPECT_TRUE(queue.put(numbered(3)));
  queue.clear();
  EXPECT_TRUE(queue.put(numbered(4)));
}

TEST(WorkQueue, HoldsOneOfEachCameraAndLetsThemTakeTurns) {
  WorkQueue queue(3);
  EXPECT_TRUE(queue.put(numbered(1), 2));
  EXPECT_TRUE(queue.put(numbered(2), 0));
  EXPECT_FALSE(queue.put(numbered(3), 0));
  EXPECT_TRUE(queue.put(numbered(4), 1));
  const auto next = [&queue] {
    const auto arrived = std::get<ArrivedImage>(*queue.take());
    return std::pair(arrived.camera, arrived.message.header().seq);
  };
  EXPECT_EQ(next(), std::pair(std::size_t{1}, 4u));
  queue.put(numbered(5), 1);  // a fast camera does not delay the others' turns
  EXPECT_EQ(next(), std::pair(std::size_t{2}, 1u));
  EXPECT_EQ(next(), std::pair(std::size_t{0}, 3u));
  EXPECT_EQ(next(), std::pair(std::size_t{1}, 5u));
}

TEST(WorkQueue, WakesTheWorker) {
  WorkQueue queue;
  std::uint32_t last = 0;
  std::thread worker([&] {
    while (const auto work = queue.take()) last = numberOf(*work);
  });
  for (std::uint32_t i = 1; i <= 1000; ++i) queue.put(numbered(i));
  while (!queue.put(numbered(1001))) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  queue.close();
  worker.join();
  EXPECT_EQ(last, 1001u);
}

int admitted(double camera_rate, double limit, double seconds) {
  RateLimit rate_limit;
  int count = 0;
  for (int i = 0; i < camera_rate * seconds; ++i) {
    // Stamps jitter by a tenth of the period.
    const double stamp = 1000 + (i + (i % 3 - 1) * 0.1) / camera_rate;
    if (rate_limit.admits(stamp, limit)) ++count;
  }
  return count;
}

TEST(RateLimit, ThinsOut) {
  EXPECT_EQ(admitted(30, 0, 10), 300);
  EXPECT_NEAR(admitted(30, 10, 10), 100, 2);
  EXPECT_NEAR(admitted(30, 7, 10), 70, 2);
  EXPECT_NEAR(admitted(30, 0.5, 10), 5, 1);
}

TEST(RateLimit, LosesNothingOfASlowerOrEqualCamera) {
  EXPECT_EQ(admitted(5, 10, 10), 50);
  EXPECT_NEAR(admitted(10, 10, 10), 100, 2);
}

TEST(RateLimit, RestartsAfterAReset) {
  RateLimit rate_limit;
  EXPECT_TRUE(rate_limit.admits(100, 1));
  EXPECT_FALSE(rate_limit.admits(50, 1));
  rate_limit.reset();
  EXPECT_TRUE(rate_limit.admits(50, 1));
}

TEST(RateLimit, FollowsAChangeOfTheRateAtOnce) {
  RateLimit rate_limit;
  int i = 0;
  const auto count = [&](double limit, int images) {
    int admitted = 0;
    for (const int end = i + images; i < end; ++i) {
      if (rate_limit.admits(1000 + 0.1 * i, limit)) ++admitted;
    }
    return admitted;
  };
  EXPECT_EQ(count(0.05, 8), 1);
  EXPECT_EQ(count(10, 10), 10);
  EXPECT_EQ(count(1, 9), 0);
  EXPECT_EQ(count(1, 10), 1);
  EXPECT_EQ(count(0, 5), 5);
}

TEST(DebugImage, HasABarAPlaceAndFitsAnyImage) {
  Model model;
  model.places = {"corridor", "kitchen"};
  Recognition recognition;
  recognition.place = 1;
  recognition.known = true;
  recognition.probabilities = Eigen::RowVector2d(0.1, 0.9);
  for (const cv::Size size : {cv::Size(320, 240), cv::Size(1, 1), cv::Size(3, 500)}) {
    for (const int type : {CV_8UC3, CV_8UC1}) {
      const cv::Mat drawn = drawAnswer(cv::Mat(size, type, cv::Scalar::all(7)), recognition, model);
      EXPECT_EQ(drawn.type(), CV_8UC3);
      EXPECT_EQ(drawn.cols, size.width);
      EXPECT_GT(drawn.rows, size.height);
    }
  }
  const cv::Mat drawn = drawAnswer(cv::Mat(240, 320, CV_8UC3, cv::Scalar()), recognition, model);
  cv::Mat bars;
  cv::inRange(drawn.rowRange(240, drawn.rows), cv::Scalar(80, 175, 40), cv::Scalar(80, 175, 40),
              bars);
  EXPECT_GT(cv::countNonZero(bars), 0);  // the green bar of the place named
  recognition.known = false;
  const cv::Mat unknown = drawAnswer(cv::Mat(240, 320, CV_8UC3, cv::Scalar()), recognition, model);
  cv::inRange(unknown.rowRange(240, unknown.rows), cv::Scalar(80, 175, 40), cv::Scalar(80, 175, 40),
              bars);
  EXPECT_EQ(cv::countNonZero(bars), 0);
}

}  // namespace
}  // namespace place_recognition
