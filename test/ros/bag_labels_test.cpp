// The labels of bags: from a topic, a file or an option.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ros/bags/bag_recording.h"
#include "ros/messages/conversions.h"
#include "ros/written_bags.h"

namespace place_recognition {
namespace {

TEST_F(Bags, ALabelThatNoImageShowsIsNamed) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    const auto say = [&bag](double time, const char* text) {
      std_msgs::String label;
      label.data = text;
      bag.write("/place_label", ros::Time(time), label);
    };
    say(100, "kitchen");
    for (int i = 0; i < 3; ++i) {
      bag.write("/image", ros::Time(100.0 + i), toImageMessage(image(i), std_msgs::Header()));
    }
    say(101.1, "attic");
    say(101.2, "kitchen");
    say(103, "cellar");
  }
  const std::unique_ptr<place_recognition::Recording> recording = openBagRecording(path_);
  for (Frame frame; recording->next(frame);) EXPECT_EQ(frame.place, "kitchen");
  ASSERT_EQ(recording->warnings().size(), 2u);
  EXPECT_NE(recording->warnings()[0].find("'attic'"), std::string::npos);
  EXPECT_NE(recording->warnings()[1].find("'cellar'"), std::string::npos);
}

TEST_F(Bags, ALabelMayHaveBeenSaidBefore) {
  writeRun(path_);
  BagRecordingOptions options;
  options.initial_label = "attic";
  EXPECT_EQ(places(readAll(path_, options)), kRooms);  // its first label applies at its start
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    bag.write("/image", ros::Time(1), toImageMessage(image(0), std_msgs::Header()));
  }
  EXPECT_EQ(places(readAll(path_, options)), std::vector<std::string>{"attic"});
  EXPECT_EQ(bagInfo(path_, options).last_label, "attic");
  EXPECT_EQ(bagInfo(path_).last_label, "");
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
      header.stamp = ros::Time(90.0 + i);  // stamps are the camera's; labels use bag time
      bag.write("/image", ros::Time(100.0 + i), toImageMessage(image(i), header));
    }
    label(102, "b");  // written after the images: order of time, not of the file
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
  BagRecordingOptions options;
  options.labels_file = scratch_ / "labels.dat";
  EXPECT_EQ(readAll(path_, options)[4].place, "lab");
  options.label = "everywhere";
  EXPECT_EQ(places(readAll(path_, options)), std::vector<std::string>(5, "everywhere"));
}

TEST_F(Bags, ABrokenLinkToALabelsFileIsNotPassedOver) {
  writeRun(path_);
  for (const char* name : {"run.labels.yaml", "run.labels.yml", "labels.dat"}) {
    const std::string link = scratch_ / name;
    std::filesystem::create_symlink("nowhere", link);
    EXPECT_NE(errorOfReading(path_).find(std::string(name) + ": it is a broken link"),
              std::string::npos);
    std::filesystem::remove(link);
  }
}

TEST_F(Bags, ALabelTopicThatWasAskedForMustBeThere) {
  writeRun(path_);
  BagRecordingOptions options;
  options.label_topic = "/rooms";
  EXPECT_NE(errorOfReading(path_, options).find("no topic /rooms for labels"), std::string::npos);
}

TEST_F(Bags, ALabelTopicOfAnotherTypeIsRefused) {
  writeRun(path_);
  BagRecordingOptions options;
  options.label_topic = "/camera/image_raw/compressed";
  EXPECT_NE(errorOfReading(path_, options).find("not std_msgs/String"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
