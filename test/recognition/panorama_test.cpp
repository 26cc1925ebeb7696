// Omnidirectional images: unrolling and finding the ring, training and recognition.

#include "recognition/frames/panorama.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "error_of.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/frames/mirror_search.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

/// Returns an image of `size` whose ring shows `value(angle, share)`. `angle`: rad,
/// counterclockwise from below; `share`: 0..1 from the rim to the inner circle.
template <typename Value>
cv::Mat drawRing(cv::Size size, const MirrorRing& ring, const Value& value) {
  cv::Mat image(size, CV_8UC1, cv::Scalar(8));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Point2d offset = cv::Point2d(x + 0.5, y + 0.5) - ring.center;
      const double radius = std::hypot(offset.x, offset.y);
      if (radius < ring.inner || radius > ring.outer) continue;
      double angle = std::atan2(offset.x, offset.y);
      if (angle < 0) angle += 2 * CV_PI;
      image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(
          value(angle, (ring.outer - radius) / (ring.outer - ring.inner)));
    }
  }
  return image;
}

/// Returns the image of a mirror that shows this panorama.
cv::Mat rolled(const cv::Mat& panorama, cv::Size size, const MirrorRing& ring) {
  cv::Mat map(size, CV_32FC2);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Point2d offset = cv::Point2d(x + 0.5, y + 0.5) - ring.center;
      double angle = std::atan2(offset.x, offset.y);
      if (angle < 0) angle += 2 * CV_PI;
      const double fraction =
          (ring.outer - std::hypot(offset.x, offset.y)) / (ring.outer - ring.inner);
      map.at<cv::Vec2f>(y, x) =
          cv::Vec2f(static_cast<float>(angle / (2 * CV_PI) * panorama.cols - 0.5),
                    static_cast<float>(fraction * panorama.rows - 0.5));
    }
  }
  cv::Mat image;
  cv::remap(panorama, image, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
            cv::Scalar::all(5));
  return image;
}

const cv::Size kSize(200, 150);
const MirrorRing kRing{{103, 72}, 16, 68};

TEST(Panorama, IsTheImageItselfWithoutAMirror) {
  const cv::Mat image = drawRoom(1, 2);
  EXPECT_EQ(Panorama(PanoramaOptions()).unrolled(image).data, image.data);
}

TEST(Panorama, HasACircleInEachRowTheRimAtTheTop) {
  const auto value = [](double angle, double fraction) {
    return 60 + 40 * std::sin(3 * angle + 1) + 80 * fraction;
  };
  Panorama panorama(optionsOf(kRing, kSize));
  const cv::Mat unrolled = panorama.unrolled(drawRing(kSize, kRing, value));
  EXPECT_EQ(unrolled.rows, 52);
  EXPECT_EQ(unrolled.cols, 264);  // pi (16 + 68)
  for (int y = 2; y < unrolled.rows - 2; ++y) {
    for (int x = 0; x < unrolled.cols; ++x) {
      EXPECT_NEAR(unrolled.at<std::uint8_t>(y, x),
                  value(2 * CV_PI * (x + 0.5) / unrolled.cols, (y + 0.5) / unrolled.rows), 3)
          << x << " " << y;
    }
  }
}

TEST(Panorama, GoesRoundWithTheRobot) {
  const cv::Size size(160, 160);
  const MirrorRing ring{{80, 80}, 16, 64};  // 80 pi columns, 251
  cv::Mat image = rolled(drawRoom(0, 1), size, ring);
  Panorama panorama(optionsOf(ring, size));
  const cv::Mat before = panorama.unrolled(image).clone();
  cv::rotate(image, image, cv::ROTATE_180);
  const cv::Mat after = panorama.unrolled(image);
  ASSERT_EQ(before.cols, 251);
  // Half a turn: 125.5 columns. Compare the means of neighbours, which lie half a column off.
  double difference = 0;
  for (int x = 0; x < 120; ++x) {
    const cv::Mat mean = (before.col(x + 125) + before.col(x + 126)) / 2;
    difference += cv::norm(mean, after.col(x), cv::NORM_L1) / (3.0 * before.rows);
  }
  EXPECT_LT(difference / 120, 5);
}

TEST(Panorama, ScalesWithTheImage) {
  const PanoramaOptions options = optionsOf(kRing, kSize);
  const MirrorRing same = ringIn(kSize, options);
  EXPECT_NEAR(same.center.x, kRing.center.x, 1e-9);
  EXPECT_NEAR(same.center.y, kRing.center.y, 1e-9);
  EXPECT_NEAR(same.inner, kRing.inner, 1e-9);
  EXPECT_NEAR(same.outer, kRing.outer, 1e-9);
  const MirrorRing twice = ringIn(kSize * 2, options);
  EXPECT_NEAR(twice.center.x, 206, 1e-9);
  EXPECT_NEAR(twice.outer, 136, 1e-9);
  Panorama panorama(options);
  EXPECT_EQ(panorama.unrolled(cv::Mat(kSize * 2, CV_8UC3)).rows, 104);
  EXPECT_EQ(panorama.unrolled(cv::Mat(kSize, CV_8UC3)).rows, 52);
}

TEST(Panorama, IsBlackBesideTheImage) {
  Panorama panorama(optionsOf({{100, 75}, 20, 95}, kSize));  // the rim above and below is cut off
  const cv::Mat unrolled = panorama.unrolled(cv::Mat(kSize, CV_8UC1, cv::Scalar(200)));
  EXPECT_EQ(unrolled.at<std::uint8_t>(0, 0), 0);
  EXPECT_EQ(unrolled.at<std::uint8_t>(0, unrolled.cols / 4), 200);
}

TEST(MirrorSearch, FindsRingsOfAnySizeAndPlace) {
  std::mt19937 random(7);
  for (int i = 0; i < 12; ++i) {
    const cv::Size size(120 + static_cast<int>(random() % 400),
                        120 + static_cast<int>(random() % 300));
    const double side = std::min(size.width, size.height);
    const auto fraction = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
    };
    MirrorRing ring;
    ring.center = {size.width / 2.0 + side * fraction(-0.07, 0.07),
                   size.height / 2.0 + side * fraction(-0.07, 0.07)};
    ring.outer = side * fraction(0.35, 0.55);
    ring.inner = ring.outer * fraction(0.15, 0.4);
    const cv::Mat image =
        rolled(drawRoom(static_cast<int>(random() % 3), random() % 100), size, ring);
    const auto found = findMirror(image);
    ASSERT_TRUE(found) << size;
    EXPECT_NEAR(found->center.x, ring.center.x, 0.02 * side) << size;
    EXPECT_NEAR(found->center.y, ring.center.y, 0.02 * side) << size;
    EXPECT_NEAR(found->outer, ring.outer, 0.02 * side) << size;
    EXPECT_NEAR(found->inner, ring.inner, 0.03 * side) << size;
  }
}

TEST(MirrorSearch, FindsNoneInOrdinaryImages) {
  for (int room = 0; room < 3; ++room) {
    for (unsigned frame = 0; frame < 5; ++frame) EXPECT_FALSE(findMirror(drawRoom(room, frame)));
  }
  EXPECT_FALSE(findMirror(cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(3))));
}

/// Returns frames of drawn rooms as seen by an omnidirectional camera.
std::vector<Frame> omniFrames(int rooms, int count, unsigned first = 0) {
  std::vector<Frame> frames = drawFrames(rooms, count, first);
  for (Frame& frame : frames) frame.image = rolled(frame.image, kSize, kRing);
  return frames;
}

TrainingOptions omniOptions() {
  TrainingOptions options = quickOptions();
  options.image.panorama.mirror = "found";
  return options;
}

TEST(OmniTraining, FindsTheMirrorOnceAndKeepsIt) {
  const ScratchFolder scratch;
  const std::string path = scratch / "omni.places";
  saveModel(train({opener(omniFrames(3, 20))}, omniOptions()).model, path);
  const auto model = std::make_shared<const Model>(loadModel(path));
  EXPECT_EQ(model->asked.image.panorama.mirror, "found");
  EXPECT_EQ(model->options.image.panorama.mirror, "given");
  const MirrorRing ring = ringIn(kSize, model->options.image.panorama);
  EXPECT_NEAR(ring.outer, kRing.outer, 3);

  Recognizer recognizer(model);
  int right = 0;
  const std::vector<Frame> test = omniFrames(3, 5, 500);
  for (const Frame& frame : test) {
    right += model->places[static_cast<std::size_t>(recognizer.recognize(frame.image).place)] ==
             frame.place;
  }
  EXPECT_GE(right, 14);

  // Images learned later are unrolled in the same way, although no mirror can be found in them.
  std::vector<Frame> dark = omniFrames(3, 6, 900);
  for (Frame& frame : dark) frame.image = frame.image * 0.1;
  const Model more = trainIncrementally(*model, {opener(dark)}, {0}).model;
  EXPECT_EQ(more.asked.image.panorama.mirror, "found");
  EXPECT_EQ(more.options.image.panorama.outer, model->options.image.panorama.outer);
}

TEST(OmniTraining, SaysThatThereIsNoMirror) {
  const std::string error = errorOf([] { train({opener(drawFrames(2, 10))}, omniOptions()); });
  EXPECT_NE(error.find("No mirror of an omnidirectional camera is found in the images of drawn"),
            std::string::npos)
      << error;
}

TEST(OmniOptions, AreChecked) {
  TrainingOptions options = quickOptions();
  options.image.panorama.mirror = "maybe";
  EXPECT_THROW(options.check(), Error);
  options.image.panorama.mirror = "given";
  EXPECT_NO_THROW(options.check());
  options.image.panorama.center_y = 1.5;
  EXPECT_THROW(options.check(), Error);
  options.image.panorama.center_y = 0.5;
  options.image.panorama.inner = 0.5;
  EXPECT_THROW(options.check(), Error);
}

}  // namespace
}  // namespace place_recognition
