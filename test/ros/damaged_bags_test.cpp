// Bags that are cut, changed, foreign or empty, and unusable messages in bags.

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "ros/messages/conversions.h"
#include "ros/written_bags.h"

namespace place_recognition {
namespace {

TEST_F(Bags, BadLabelsAreRefused) {
  for (const std::string& bad :
       {std::string(1 << 20, 'x'), std::string("a\nb"), std::string("\xff")}) {
    {
      rosbag::Bag bag(path_, rosbag::bagmode::Write);
      std_msgs::String message;
      message.data = bad;
      bag.write("/place_label", ros::Time(1), message);
      bag.write("/image", ros::Time(2), toImageMessage(image(0), std_msgs::Header()));
    }
    const std::string error = errorOfReading(path_);
    EXPECT_NE(error.find("/place_label at 0 s (a file RUN.labels.yaml"), std::string::npos)
        << error;
    EXPECT_NE(error.find("): the label '"), std::string::npos) << error;
    EXPECT_LT(error.size(), 400u);
  }
}

TEST_F(Bags, WithoutImagesTellTheirTopics) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.write("/place_label", ros::Time(1), std_msgs::String());
  }
  EXPECT_NE(
      errorOfReading(path_).find("has no images; its topics are /place_label (std_msgs/String)"),
      std::string::npos)
      << errorOfReading(path_);
}

TEST_F(Bags, ImagesThatCannotBeUsedAreFramesWithAProblem) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    sensor_msgs::Image message = toImageMessage(image(0), std_msgs::Header());
    bag.write("/image", ros::Time(1), message);
    message.height = 65537;
    bag.write("/image", ros::Time(2), message);
    message = toImageMessage(image(2).rowRange(0, 5), std_msgs::Header());
    bag.write("/image", ros::Time(3), message);
  }
  const std::vector<Frame> frames = readAll(path_);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_FALSE(frames[0].image.empty());
  EXPECT_TRUE(frames[1].image.empty());
  EXPECT_NE(frames[1].problem.find("65537"), std::string::npos);
  EXPECT_EQ(frames[2].image.rows, 5);
}

TEST_F(Bags, FilesThatAreNotBagsAreRefused) {
  EXPECT_NE(errorOfReading(scratch_ / "none.bag").find("There is no bag"), std::string::npos);
  EXPECT_NE(errorOfReading(scratch_.write("empty.bag", "")).find("empty.bag"), std::string::npos);
  EXPECT_NE(errorOfReading(scratch_.write("text.bag", "not a bag at all\n")), "");
  EXPECT_NE(errorOfReading(scratch_ / "."), "");
}

/// A bag left behind by a killed recorder: the header has no index position yet.
std::string unindexed(std::string bytes) {
  const std::size_t field = bytes.find("index_pos=");
  EXPECT_NE(field, std::string::npos);
  bytes.replace(field + 10, 8, 8, '\0');
  return bytes;
}

TEST_F(Bags, AnUnindexedBagAsksToBeIndexed) {
  writeRun(path_);
  const std::string bytes = unindexed(readBytesOf(path_));
  EXPECT_NE(errorOfReading(scratch_.write("cut.bag", bytes)).find("rosbag reindex"),
            std::string::npos);
  const std::string active = scratch_.write("monday.bag.active", bytes);
  EXPECT_NE(errorOfReading(active).find("rosbag reindex " + active + ", and rename it to " +
                                        (scratch_ / "monday.bag")),
            std::string::npos)
      << errorOfReading(active);
}

TEST_F(Bags, FilesOfOtherKindsAreNamed) {
  const auto expect = [this](const std::string& bytes, const std::string& words) {
    const std::string error = errorOfReading(scratch_.write("x.bag", bytes));
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_NE(error.find("x.bag"), std::string::npos) << error;
    EXPECT_EQ(error.find("byte"), std::string::npos) << error;
  };
  expect("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n", "git lfs pull");
  expect("<!DOCTYPE html>\n<html>", "web page");
  expect("\x1f\x8b\x08 ", "gunzip");
  expect("BZh91AY", "bunzip2");
  expect("PK\x03\x04 ", "unzip");
  expect("SQLite format 3", "ROS 2");
  expect("\x89MCAP0\r\n", "ROS 2");
  expect("#ROSBAG V1.2\n", "rosbag fix");
  expect("", "empty");
  std::filesystem::create_directories(scratch_ / "folder.bag");
  EXPECT_NE(errorOfReading(scratch_ / "folder.bag").find("is a folder"), std::string::npos);
  scratch_.write("folder.bag/metadata.yaml", "rosbag2_bagfile_information:\n");
  scratch_.write("folder.bag/x_0.db3", "SQLite format 3");
  EXPECT_NE(errorOfReading(scratch_ / "folder.bag").find("ROS 2"), std::string::npos);
  std::filesystem::create_symlink("nowhere", scratch_ / "link.bag");
  EXPECT_NE(errorOfReading(scratch_ / "link.bag").find("is a broken link"), std::string::npos);
}

TEST_F(Bags, CutOrChangedBagsAreErrorsOrReadable) {
  LabelledBagOptions raw;
  raw.jpeg = false;
  writeRun(path_, raw);
  const std::string good = readBytesOf(path_);
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < 60; ++i) {
    std::string bytes = good;
    if (i % 3 == 0) {
      bytes.resize(random() % good.size());
    } else {
      // Damages the structure of the bag rather than the pixels.
      const std::size_t end = i % 3 == 1 ? 4096 + 400 : good.size();
      const std::size_t begin = i % 3 == 1 ? 0 : good.size() - 2500;
      for (int k = 0; k < 4; ++k) {
        bytes[begin + random() % (end - begin)] = static_cast<char>(random());
      }
    }
    const std::string changed = scratch_.write("changed.bag", bytes);
    const std::string error = errorOfReading(changed);
    if (error.empty()) continue;
    ++refused;
    EXPECT_NE(error.find(changed), std::string::npos) << error;
  }
  EXPECT_GT(refused, 20);
}

TEST_F(Bags, AReaderEndsBeforeTheEndOfARun) {
  writeRun(path_);
  const auto recording = openBagRecording(path_);
  Frame frame;
  EXPECT_TRUE(recording->next(frame));
}

}  // namespace
}  // namespace place_recognition
