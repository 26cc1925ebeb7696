// Bags that are written here and read back: raw, JPEG, bz2, lz4; topics, times and cameras.

#include "ros/bags/bag_recording.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "ros/bags/labelled_bag_writer.h"
#include "ros/messages/conversions.h"
#include "ros/written_bags.h"

namespace place_recognition {
namespace {

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
    EXPECT_LE(cv::norm(frames[i].image, image(static_cast<int>(i)), cv::NORM_INF),
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
  BagRecordingOptions options;
  options.image_topics = {"/camera/image_raw"};
  EXPECT_EQ(readAll(path_, options).size(), kRooms.size());
}

TEST_F(Bags, SlashesBeforeTopicsDoNotMatter) {
  LabelledBagOptions written;
  written.image_topic = "camera/image_raw";
  written.label_topic = "place_label";
  writeRun(path_, written);
  EXPECT_EQ(places(readAll(path_)), kRooms);
  for (const char* image :
       {"/camera/image_raw", "camera/image_raw", "/camera/image_raw/compressed"}) {
    for (const char* label : {"/place_label", "place_label", "//place_label"}) {
      BagRecordingOptions options;
      options.image_topics = {image};
      options.label_topic = label;
      EXPECT_EQ(places(readAll(path_, options)), kRooms) << image << " " << label;
    }
  }
  writeRun(path_);
  BagRecordingOptions bare;
  bare.image_topics = {"camera/image_raw"};
  bare.label_topic = "place_label";
  EXPECT_EQ(places(readAll(path_, bare)), kRooms);
}

/// Writes one image on each topic.
void writeTopics(const std::string& path, const std::vector<std::string>& raw,
                 const std::vector<std::string>& compressed) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  for (const std::string& topic : raw) {
    bag.write(topic, ros::Time(1), toImageMessage(image(0), std_msgs::Header()));
  }
  for (const std::string& topic : compressed) {
    bag.write(topic, ros::Time(1), sensor_msgs::CompressedImage());
  }
}

TEST_F(Bags, TheOnlyCameraIsTaken) {
  writeTopics(path_, {"/camera/color/image_raw"},
              {"/camera/color/image_raw/compressed", "/camera/depth/image_raw/compressedDepth"});
  const std::vector<Frame> frames = readAll(path_);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].name, "/camera/color/image_raw #1");
}

TEST_F(Bags, OneOfSeveralCamerasIsAskedFor) {
  writeTopics(path_, {"/left/image_raw", "/right/image_raw"}, {"/depth/compressedDepth"});
  const std::string error = errorOfReading(path_);
  EXPECT_NE(error.find("--image-topic"), std::string::npos) << error;
  EXPECT_NE(error.find("/right/image_raw"), std::string::npos) << error;
  EXPECT_EQ(error.find("compressedDepth"), std::string::npos) << error;
  EXPECT_EQ(error.find("byte"), std::string::npos) << error;
}

TEST_F(Bags, OneOddImageAtTheStartDoesNotDecideTheSize) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    for (int i = 0; i < 5; ++i) {
      cv::Mat shown = image(i);
      if (i == 0) cv::resize(shown, shown, cv::Size(4, 3));
      bag.write("/image", ros::Time(1.5e9 + i), toImageMessage(shown, std_msgs::Header()));
    }
  }
  EXPECT_EQ(openBagRecording(path_)->usualSize(), image(0).size());
}

TEST_F(Bags, InfraredOfTenBitsKeepsItsLevels) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    sensor_msgs::Image message;
    message.encoding = "mono16";
    message.width = message.height = 32;
    message.step = 64;
    for (int frame = 0; frame < 3; ++frame) {
      message.data.clear();
      for (int i = 0; i < 32 * 32; ++i) {  // to 255, 511 and 1023
        const int value = i >> (2 - frame);
        message.data.push_back(static_cast<std::uint8_t>(value & 0xff));
        message.data.push_back(static_cast<std::uint8_t>(value >> 8));
      }
      bag.write("/infra", ros::Time(1 + frame), message);
    }
  }
  const std::unique_ptr<place_recognition::Recording> recording = openBagRecording(path_);
  Frame frame;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(recording->next(frame));
    ASSERT_EQ(frame.image.type(), CV_8UC1);
    double largest = 0;
    cv::minMaxLoc(frame.image, nullptr, &largest);
    EXPECT_EQ(largest, (255 >> (2 - i)));  // all scaled alike
  }
  EXPECT_FALSE(recording->next(frame));
  ASSERT_EQ(recording->warnings().size(), 1u);
  EXPECT_NE(recording->warnings()[0].find("0 .. 1023"), std::string::npos);
  EXPECT_GT(recording->levelRange().high, 1000u);

  const std::unique_ptr<place_recognition::Recording> again = openBagRecording(path_);
  again->setLevelRange({0, 4000});  // as of a model
  for (double largest = 0; again->next(frame);) {
    double of_this = 0;
    cv::minMaxLoc(frame.image, nullptr, &of_this);
    largest = std::max(largest, of_this);
    EXPECT_LE(largest, 1023 / 16);
  }
  EXPECT_NE(again->warnings()[0].find("0 .. 4095 of 16 bits, as in training"), std::string::npos);
}

TEST_F(Bags, WithTwoCamerasAskForOne) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.write("/left", ros::Time(1), toImageMessage(image(1), std_msgs::Header()));
    bag.write("/right", ros::Time(1), toImageMessage(image(2), std_msgs::Header()));
  }
  EXPECT_NE(errorOfReading(path_).find("/left (sensor_msgs/Image), /right (sensor_msgs/Image)"),
            std::string::npos);
  BagRecordingOptions options;
  options.image_topics = {"/right"};
  ASSERT_EQ(readAll(path_, options).size(), 1u);
  options.image_topics = {"/middle"};
  EXPECT_NE(errorOfReading(path_, options).find("no images on /middle"), std::string::npos);
}

TEST_F(Bags, OfSeveralCamerasAreReadTogetherInOrderOfTime) {
  {
    LabelledBagOptions raw;
    raw.jpeg = false;
    LabelledBagWriter writer(path_, raw);
    writer.write(image(1), "hall", 0, "front");
    writer.write(image(2), "hall", 0.5, "rear");
    writer.write(image(3), "lab", 1, "rear");
    writer.write(image(4), "lab", 1, "left");
    writer.write(image(5), "lab", 2, "front");
    writer.close();
  }
  BagRecordingOptions options;
  options.image_topics = {"rear/image_raw", "/front/image_raw"};
  const std::vector<Frame> frames = readAll(path_, options);
  ASSERT_EQ(frames.size(), 4u);
  const std::vector<int> cameras{1, 0, 0, 1};
  const std::vector<int> images{1, 2, 3, 5};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].camera, cameras[i]);
    EXPECT_EQ(cv::norm(frames[i].image, image(images[i]), cv::NORM_INF), 0);
  }
  EXPECT_EQ(frames[1].name, "/rear/image_raw #1");
  EXPECT_EQ(openBagRecording(path_, options)->cameras(),
            (std::vector<std::string>{"/rear/image_raw", "/front/image_raw"}));
  options.image_topics.push_back("rear/image_raw");
  EXPECT_NE(errorOfReading(path_, options).find("/rear/image_raw is named twice"),
            std::string::npos);
  options.image_topics.back() = "/right";
  EXPECT_NE(errorOfReading(path_, options).find("no images on /right"), std::string::npos);
  options.image_topics.assign(9, "rear/image_raw");
  EXPECT_NE(errorOfReading(path_, options).find("at most 8 cameras"), std::string::npos);
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
    writer.write(image(0), "a", 0);
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch_ / "."));
  EXPECT_THROW(LabelledBagWriter(scratch_ / "no/such/folder/run.bag"), Error);
}

TEST(RealBag, ItsOneImageIsRead) {
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
