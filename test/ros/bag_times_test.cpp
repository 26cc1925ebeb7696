// The times of bags and the stamps of their images: clocks that were not set, gaps, stamps that
// stand still.

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ros/bags/bag_recording.h"
#include "ros/messages/conversions.h"
#include "ros/written_bags.h"

namespace place_recognition {
namespace {

TEST_F(Bags, AClockThatWasNotSetDoesNotCount) {
  for (const double odd : {1e-9, 100.0, 1.5e9 - 400 * 86400}) {
    {
      rosbag::Bag bag(path_, rosbag::bagmode::Write);
      std_msgs::String label;
      bag.write("/rosout", ros::Time(odd), label);
      bag.write("/image", ros::Time(odd), toImageMessage(image(0), std_msgs::Header()));
      bag.write("/clock_is_set", ros::Time(1.5e9 - 1), label);
      for (int i = 0; i < 3; ++i) {
        bag.write("/image", ros::Time(1.5e9 + i), toImageMessage(image(i), std_msgs::Header()));
      }
    }
    const BagInfo info = bagInfo(path_);
    EXPECT_DOUBLE_EQ(info.start, 1.5e9 - 1);
    EXPECT_DOUBLE_EQ(info.duration, 3);
    EXPECT_EQ(info.other_images, 1u);
  }
}

TEST_F(Bags, AMessageLongBeforeOrAfterDoesNotCount) {
  const double seventy_years = 70 * 365.25 * 86400;  // more than a ros::Duration holds
  for (const double odd : {1.5e9 - 3600, 1.5e9 - 20 * 3600, 1.5e9 + 3600, 1.5e9 + seventy_years}) {
    {
      rosbag::Bag bag(path_, rosbag::bagmode::Write);
      for (int i = 0; i < 3; ++i) {
        bag.write("/image", ros::Time(1.5e9 + i), toImageMessage(image(i), std_msgs::Header()));
      }
      bag.write("/rosout", ros::Time(odd), std_msgs::String());
      if (odd > 2e9) {
        bag.write("/image", ros::Time(odd), toImageMessage(image(0), std_msgs::Header()));
      }
    }
    const BagInfo info = bagInfo(path_);
    EXPECT_DOUBLE_EQ(info.start, 1.5e9);
    EXPECT_DOUBLE_EQ(info.duration, 2);
  }
}

/// Some drivers give all images the same stamp, others repeat one for a moment.
TEST_F(Bags, StampsThatStandStillGiveWayToTheTimesOfTheBag) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    std_msgs::Header header;
    header.stamp = ros::Time(7);
    for (int i = 0; i < 12; ++i) {  // four per second
      bag.write("/still", ros::Time(1.5e9 + 0.25 * i), toImageMessage(image(i), header));
      header.stamp = ros::Time(100 + i / 2);
      bag.write("/repeated", ros::Time(1.5e9 + 0.25 * i + 0.1), toImageMessage(image(i), header));
      header.stamp = ros::Time(7);
    }
  }
  BagRecordingOptions options;
  options.image_topics = {"/still", "/repeated"};
  const std::unique_ptr<Recording> recording = openBagRecording(path_, options);
  std::map<int, std::vector<double>> stamps;  // by camera
  for (Frame frame; recording->next(frame);) stamps[frame.camera].push_back(frame.stamp);
  ASSERT_EQ(stamps[0].size(), 12u);
  ASSERT_EQ(stamps[1].size(), 12u);
  for (int i = 0; i < 12; ++i) {
    EXPECT_DOUBLE_EQ(stamps[0][i], i < 4 ? 7 : 1.5e9 + 0.25 * i);
    EXPECT_DOUBLE_EQ(stamps[1][i], 100 + i / 2);
  }
  EXPECT_EQ(recording->warnings(),
            std::vector<std::string>{path_ +
                                     ": the stamps of the images on /still stand still at 7.000 s; "
                                     "images count at the times of their recording."});
}

TEST_F(Bags, ACameraThatStartsLateOrPausesDoesNotCutTheRecording) {
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    for (int minute = 0; minute < 30; ++minute) {
      bag.write("/odom", ros::Time(1.5e9 + 60 * minute), std_msgs::String());
    }
    for (const double minute : {40.0, 100.0}) {  // a lunch break
      bag.write("/image", ros::Time(1.5e9 + 60 * minute),
                toImageMessage(image(0), std_msgs::Header()));
    }
  }
  EXPECT_DOUBLE_EQ(bagInfo(path_).start, 1.5e9 + 40 * 60);  // 11 minutes after the last message
  {
    rosbag::Bag bag(path_, rosbag::bagmode::Append);
    bag.write("/odom", ros::Time(1.5e9 + 60 * 35), std_msgs::String());
  }
  const BagInfo info = bagInfo(path_);
  EXPECT_DOUBLE_EQ(info.start, 1.5e9);
  EXPECT_DOUBLE_EQ(info.duration, 100 * 60);
}

}  // namespace
}  // namespace place_recognition
