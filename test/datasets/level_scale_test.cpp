// 16-bit images in 8 bits: the camera's levels are kept as far as 8 bits allow.

#include "datasets/level_scale.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>

#include "datasets/image_sequence.h"
#include "place_recognition/level_range.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

/// Returns an image with values from `low` to `high` in equal parts.
cv::Mat ramp(int low, int high, int channels = 1) {
  cv::Mat image(64, 64, CV_16UC(channels));
  const int count = image.rows * image.cols * channels;
  for (int i = 0; i < count; ++i) {
    image.ptr<std::uint16_t>()[i] =
        static_cast<std::uint16_t>(low + static_cast<std::int64_t>(high - low) * i / (count - 1));
  }
  return image;
}

std::size_t levelsOf(const cv::Mat& image) {
  return std::set<int>(image.begin<std::uint8_t>(), image.end<std::uint8_t>()).size();
}

TEST(LevelScale, KeepsTheLevelsOfEveryCamera) {
  for (const int bits : {8, 10, 12, 14, 16}) {
    LevelScale scale;
    const cv::Mat image = ramp(0, (1 << bits) - 1);
    const cv::Mat scaled = scale.toEightBits(image);
    ASSERT_EQ(scaled.type(), CV_8UC1);
    EXPECT_EQ(levelsOf(scaled), 256u) << bits;
    // Value v of n bits is level v * 2^(8 - n).
    for (int i = 0; i < 4096; i += 97) {
      EXPECT_EQ(scaled.data[i], image.ptr<std::uint16_t>()[i] >> (bits - 8)) << bits;
    }
  }
}

TEST(LevelScale, IsTheSameForADarkSceneOfTheSameCamera) {
  LevelScale bright, dark;
  bright.see(levelRangeOf(ramp(10, 1000)));
  dark.see(levelRangeOf(ramp(0, 600)));
  EXPECT_EQ(bright.text(), dark.text());
  EXPECT_EQ(bright.text(), "0 .. 1023 of 16 bits");
}

TEST(LevelScale, ShowsAThermalCameraThatIsFarFromZero) {
  LevelScale scale;
  const cv::Mat scaled = scale.toEightBits(ramp(7000, 9000));
  EXPECT_GT(levelsOf(scaled), 64u);
  // Slightly colder and warmer objects are still distinguished.
  EXPECT_GT(scale.toEightBits(cv::Mat(4, 4, CV_16UC1, cv::Scalar(6800))).at<std::uint8_t>(0, 0), 0);
}

TEST(LevelScale, WidensWithWhatComesAndIgnoresAFewBrightPixels) {
  LevelScale scale;
  cv::Mat image = ramp(0, 900);
  image.at<std::uint16_t>(3, 3) = 65535;
  scale.see(levelRangeOf(image));
  EXPECT_EQ(scale.text(), "0 .. 1023 of 16 bits");
  scale.see(levelRangeOf(ramp(0, 4000)));
  EXPECT_EQ(scale.text(), "0 .. 4095 of 16 bits");
  scale.see(levelRangeOf(ramp(0, 100)));
  EXPECT_EQ(scale.text(), "0 .. 4095 of 16 bits");
}

TEST(LevelScale, KeepsARangeThatWasGiven) {
  LevelScale scale(LevelRange{10, 900});
  EXPECT_TRUE(scale.hasSeen());
  EXPECT_EQ(scale.toEightBits(ramp(0, 200)).at<std::uint8_t>(63, 63), 200 / 4);
  EXPECT_EQ(scale.toEightBits(ramp(0, 60000)).at<std::uint8_t>(63, 63), 255);
  EXPECT_EQ(scale.text(), "0 .. 1023 of 16 bits, as in training");
}

TEST(LevelRange, IsThatOfAllUnited) {
  const LevelRange whole = united(united({}, {20, 300}), united({10, 200}, {}));
  EXPECT_EQ(whole.low, 10u);
  EXPECT_EQ(whole.high, 300u);
  EXPECT_FALSE(united({}, {}).known());
}

TEST(LevelScale, LeavesEightBitsAloneAndTakesColour) {
  LevelScale scale;
  const cv::Mat image(4, 4, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_EQ(scale.toEightBits(image).data, image.data);
  EXPECT_FALSE(scale.hasSeen());
  EXPECT_EQ(scale.toEightBits(ramp(0, 4095, 3)).type(), CV_8UC3);
  EXPECT_EQ(scale.toEightBits(cv::Mat(1, 1, CV_16UC1, cv::Scalar(7))).type(), CV_8UC1);
}

TEST(ImageSequence, HasTheSizeOfMostImages) {
  const ScratchFolder scratch;
  std::vector<std::string> paths;
  for (int i = 0; i < 40; ++i) {
    paths.push_back(scratch / (std::to_string(i) + ".png"));
    const cv::Size size = i < 3 ? cv::Size(8, 6) : cv::Size(16, 12);
    if (i > 0) cv::imwrite(paths.back(), cv::Mat(size, CV_8UC3, cv::Scalar::all(9)));
  }
  EXPECT_EQ(ImageSequence(paths).usualSize(), cv::Size(16, 12));
  EXPECT_EQ(ImageSequence({paths[0], paths[1], paths[4], paths[2]}).usualSize(), cv::Size(8, 6));
  // All that is sampled is missing.
  std::vector<std::string> missing(32, paths[0]);
  missing[31] = paths[1];
  EXPECT_EQ(ImageSequence(missing).usualSize(), cv::Size(8, 6));
  EXPECT_EQ(ImageSequence({paths[0]}).usualSize(), cv::Size());
}

TEST(ImageSequence, ShowsAllImagesAlike) {
  const ScratchFolder scratch;
  std::vector<std::string> paths;
  for (const int high : {100, 300, 1000}) {
    paths.push_back(scratch / (std::to_string(high) + ".png"));
    ASSERT_TRUE(cv::imwrite(paths.back(), ramp(0, high)));
  }
  ImageSequence images(paths);
  double largest = 0;
  cv::minMaxLoc(images.read(0).image, nullptr, &largest);
  EXPECT_EQ(largest, 100 / 4);
  EXPECT_NE(images.note().find("0 .. 1023"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
