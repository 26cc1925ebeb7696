// Bags written here and read back: raw, JPEG, bz2, lz4; labelled in three ways; and damaged ones.

#include "ros/bag_run.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include <cstdlib>
#include <fstream>
#include <opencv2/core.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "place_recognition/error.h"
#include "ros/conversions.h"
#include "ros/labelled_bag_writer.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

/// A picture that tells its number by its grey level.
cv::Mat picture(int number) { return cv::Mat(12, 16, CV_8UC3, cv::Scalar::all(10 + 10 * number)); }

/// Rooms of the pictures of writeRun(): one a second.
const std::vector<std::string> kRooms = {"kitchen", "kitchen", "", "corridor", "corridor"};

void writeRun(const std::string& path, const LabelledBagOptions& options = {}) {
  LabelledBagWriter writer(path, options);
  for (std::size_t i = 0; i < kRooms.size(); ++i) {
    writer.write(picture(static_cast<int>(i)), kRooms[i], static_cast<double>(i));
  }
  writer.close();
}

std::vector<Frame> readAll(const std::string& path, const BagRunOptions& options = {}) {
  const std::unique_ptr<Run> run = openBagRun(path, options);
  std::vector<Frame> frames;
  Frame frame;
  while (run->next(frame)) frames.push_back(frame);
  EXPECT_EQ(run->fraction(), 1);
  return frames;
}

std::vector<std::string> places(const std::vector<Frame>& frames) {
  std::vector<std::string> names;
  for (const Frame& frame : frames) names.push_back(frame.place);
  return names;
}

std::string errorOf(const std::string& path, const BagRunOptions& options = {}) {
  try {
    const std::unique_ptr<Run> run = openBagRun(path, options);
    Frame frame;
    while (run->next(frame)) {
    }
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

std::string readBytesOf(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

class Bags : public testing::Test {
 protected:
  ScratchFolder scratch_;
  const std::string path_ = scratch_ / "run.bag";
};

struct Format {
  bool jpeg;
  LabelledBagOptions::Compression compression;
};

class BagFormats : public Bags, public testing::WithParamInterface<Format> {};

TEST_P(BagFormats, ComeBackAsWritten) {
  LabelledBagOptions options;
  options.jpeg = GetParam().jpeg;
  options.compression = GetParam().compression;
  writeRun(path_, options);
  const std::vector<Frame> frames = readAll(path_);
  ASSERT_EQ(places(frames), kRooms);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_DOUBLE_EQ(frames[i].stamp, options.base_time + static_cast<double>(i));
    EXPECT_EQ(frames[i].problem, "");
    ASSERT_EQ(frames[i].image.type(), CV_8UC3);
    EXPECT_LE(cv::norm(frames[i].image, picture(static_cast<int>(i)), cv::NORM_INF),
              options.jpeg ? 3 : 0);
  }
  EXPECT_EQ(frames[1].name,
            options.jpeg ? "/camera/image_raw/compressed #2" : "/camera/image_raw #2");
}

INSTANTIATE_TEST_SUITE_P(All, BagFormats,
                         testing::Values(Format{false, LabelledBagOptions::Compression::kNone},
                                         Format{true, LabelledBagOptions::Compression::kNone},
                                         Format{false, LabelledBagOptions::Compression::kLz4},
                                         Format{true, LabelledBagOptions::Compression::kBz2}));

TEST_F(Bags, AreReadByTheNameOfTheirTopicWithoutCompressed) {
  writeRun(path_);
  BagRunOptions options;
  options.image_topic = "/camera/image_raw";
  EXPECT_EQ(readAll(path_, options).size(), kRooms.size());
}

TEST_F(Bags, LabelsHoldFromTheirTimeOn) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    const auto label = [&bag](double time, const std::string& text) {
      std_msgs::String message;
      message.data = text;
      bag.write("/place_label", ros::Time(time), message);
    };
    for (int i = 0; i < 6; ++i) {
      std_msgs::Header header;
      header.stamp = ros::Time(90.0 + i);  // stamps are of the camera; labels go by bag time
      bag.write("/image", ros::Time(100.0 + i), toImageMessage(picture(i), header));
    }
    label(102, "b");  // written after the images: the order of time counts, not that of the file
    label(101, "a");
    label(104.5, "");
  }
  const std::vector<Frame> frames = readAll(path_);
  EXPECT_EQ(places(frames), (std::vector<std::string>{"", "a", "b", "b", "b", ""}));
  EXPECT_EQ(frames[0].stamp, 90);
}

TEST_F(Bags, ALabelsFileBesideTheBagComesBeforeTheTopic) {
  writeRun(path_);
  scratch_.write("labels.dat", "1000000001 hall\n1000000003 lab\n");
  EXPECT_EQ(places(readAll(path_)), (std::vector<std::string>{"", "hall", "hall", "lab", "lab"}));
  scratch_.write("run.labels.yaml", "labels: [{from: 0, to: 1.5, place: office}]");
  EXPECT_EQ(places(readAll(path_)), (std::vector<std::string>{"office", "office", "", "", ""}));
  BagRunOptions options;
  options.labels_file = scratch_ / "labels.dat";
  EXPECT_EQ(readAll(path_, options)[4].place, "lab");
  options.label = "everywhere";
  EXPECT_EQ(places(readAll(path_, options)), std::vector<std::string>(5, "everywhere"));
}

TEST_F(Bags, BadLabelsAreRefused) {
  for (const std::string& bad :
       {std::string(1 << 20, 'x'), std::string("a\nb"), std::string("\xff")}) {
    {
      rosbag::Bag bag(path_, rosbag::bagmode::Write);
      std_msgs::String message;
      message.data = bad;
      bag.write("/place_label", ros::Time(1), message);
      bag.write("/image", ros::Time(2), toImageMessage(picture(0), std_msgs::Header()));
    }
    EXPECT_NE(errorOf(path_).find("/place_label at 0 s: the label"), std::string::npos);
    EXPECT_LT(errorOf(path_).size(), 400u);
  }
}

TEST_F(Bags, WithoutImagesTellTheirTopics) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.write("/place_label", ros::Time(1), std_msgs::String());
  }
  EXPECT_NE(errorOf(path_).find("has no images; its topics are /place_label (std_msgs/String)"),
            std::string::npos)
      << errorOf(path_);
}

TEST_F(Bags, WithTwoCamerasAskForOne) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.write("/left", ros::Time(1), toImageMessage(picture(1), std_msgs::Header()));
    bag.write("/right", ros::Time(1), toImageMessage(picture(2), std_msgs::Header()));
  }
  EXPECT_NE(errorOf(path_).find("/left (sensor_msgs/Image), /right (sensor_msgs/Image)"),
            std::string::npos);
  BagRunOptions options;
  options.image_topic = "/right";
  ASSERT_EQ(readAll(path_, options).size(), 1u);
  options.image_topic = "/middle";
  EXPECT_NE(errorOf(path_, options).find("no images on /middle"), std::string::npos);
}

TEST_F(Bags, ALabelTopicThatWasAskedForMustBeThere) {
  writeRun(path_);
  BagRunOptions options;
  options.label_topic = "/rooms";
  EXPECT_NE(errorOf(path_, options).find("no topic /rooms for labels"), std::string::npos);
}

TEST_F(Bags, ALabelTopicOfAnotherTypeIsRefused) {
  writeRun(path_);
  BagRunOptions options;
  options.label_topic = "/camera/image_raw/compressed";
  EXPECT_NE(errorOf(path_, options).find("not of std_msgs/String"), std::string::npos);
}

TEST_F(Bags, PicturesThatCannotBeUsedAreFramesWithAProblem) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    sensor_msgs::Image message = toImageMessage(picture(0), std_msgs::Header());
    bag.write("/image", ros::Time(1), message);
    message.height = 65537;
    bag.write("/image", ros::Time(2), message);
    message = toImageMessage(picture(2).rowRange(0, 5), std_msgs::Header());
    bag.write("/image", ros::Time(3), message);
  }
  const std::vector<Frame> frames = readAll(path_);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_FALSE(frames[0].image.empty());
  EXPECT_TRUE(frames[1].image.empty());
  EXPECT_NE(frames[1].problem.find("65537"), std::string::npos);
  EXPECT_EQ(frames[2].image.rows, 5);
}

TEST_F(Bags, FilesThatAreNoBagAreRefused) {
  EXPECT_NE(errorOf(scratch_ / "none.bag").find("There is no bag"), std::string::npos);
  EXPECT_NE(errorOf(scratch_.write("empty.bag", "")).find("empty.bag"), std::string::npos);
  EXPECT_NE(errorOf(scratch_.write("text.bag", "not a bag at all\n")), "");
  EXPECT_NE(errorOf(scratch_ / "."), "");
}

TEST_F(Bags, AnUnindexedBagAsksToBeIndexed) {
  writeRun(path_);
  // As left by a recorder that was killed: the header has no index position yet.
  std::string bytes = readBytesOf(path_);
  const std::size_t field = bytes.find("index_pos=");
  ASSERT_NE(field, std::string::npos);
  bytes.replace(field + 10, 8, 8, '\0');
  EXPECT_NE(errorOf(scratch_.write("cut.bag", bytes)).find("rosbag reindex"), std::string::npos);
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
      // Where the structure of the bag is, rather than among the pixels.
      const std::size_t end = i % 3 == 1 ? 4096 + 400 : good.size();
      const std::size_t begin = i % 3 == 1 ? 0 : good.size() - 2500;
      for (int k = 0; k < 4; ++k) {
        bytes[begin + random() % (end - begin)] = static_cast<char>(random());
      }
    }
    const std::string changed = scratch_.write("changed.bag", bytes);
    const std::string error = errorOf(changed);
    if (error.empty()) continue;
    ++refused;
    EXPECT_NE(error.find(changed), std::string::npos) << error;
  }
  EXPECT_GT(refused, 20);
}

TEST_F(Bags, ARunThatIsNotReadToItsEndEnds) {
  writeRun(path_);
  const auto run = openBagRun(path_);
  Frame frame;
  EXPECT_TRUE(run->next(frame));
}

TEST_F(Bags, InfoTellsTopicsSizesAndLabels) {
  writeRun(path_);
  const BagInfo info = bagInfo(path_);
  EXPECT_DOUBLE_EQ(info.start, 1e9);
  EXPECT_DOUBLE_EQ(info.duration, 4);
  ASSERT_EQ(info.topics.size(), 2u);
  EXPECT_EQ(info.topics[0].name, "/camera/image_raw/compressed");
  EXPECT_EQ(info.topics[0].messages, 5u);
  EXPECT_EQ(info.topics[0].width, 16);
  EXPECT_EQ(info.topics[0].height, 12);
  EXPECT_EQ(info.topics[1].name, "/place_label");
  ASSERT_EQ(info.labels.size(), 2u);
  EXPECT_EQ(info.labels[0].place, "kitchen");
  EXPECT_DOUBLE_EQ(info.labels[0].to, 2);
  EXPECT_DOUBLE_EQ(info.labels[1].from, 3);
}

TEST_F(Bags, ABagWithoutNameYetIsLeftByNoOne) {
  {
    LabelledBagWriter writer(path_);
    writer.write(picture(0), "a", 0);
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch_ / "."));
  EXPECT_THROW(LabelledBagWriter(scratch_ / "no/such/folder/run.bag"), Error);
}

TEST(RealBag, ItsOnePictureIsRead) {
  const char* data = std::getenv("PLACE_RECOGNITION_TEST_DATA");
  const std::string path = std::string(data ? data : "") + "/real_bag/aruco_images.bag";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const std::vector<Frame> frames = readAll(path);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].problem, "");
  EXPECT_EQ(frames[0].place, "");
  EXPECT_GT(frames[0].image.cols, 100);
}

}  // namespace
}  // namespace place_recognition
