// Eight hours of a robot's time in seconds: a frame every nine seconds of simulated time, odometry,
// listeners that come and go and models that are replaced; memory must stay flat. See
// endurance.test.

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <visualization_msgs/Marker.h>

#include "ros/node_process.h"
#include "ros/recognizer_fixture.h"
#include "ros/rostest_main.h"

namespace place_recognition {
namespace {

constexpr double kStart = 1e6;      // s
constexpr double kHour = 3600;      // s
constexpr double kFramePeriod = 9;  // s
constexpr int kFramesAnHour = static_cast<int>(kHour / kFramePeriod);
constexpr int kHours = 8;
constexpr double kMaxGrowth = 2;  // MB

class Endurance : public RecognizerNode {
 protected:
  Endurance() : RecognizerNode("/recognizer") {}

  void driveAnHour(int hour) {
    Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
    const Inbox<PlaceRecognition> smoothed(node_, name_ + "/smoothed");
    const Inbox<visualization_msgs::Marker> markers(node_, name_ + "/marker");
    ASSERT_TRUE(eventually([&] {  // until all topics are connected
      camera_.send(toImageMessage(drawRoom(0, 0), headerAt(kStart + hour * kHour)));
      ros::WallDuration(0.05).sleep();
      return !answers.messages().empty();
    }));
    for (int i = 0; i < kFramesAnHour; ++i) {
      const double stamp = kStart + hour * kHour + i * kFramePeriod;
      nav_msgs::Odometry odometry;
      odometry.header.stamp = ros::Time(stamp);
      odometry.pose.pose.position.x = 0.1 * i;
      odometry.pose.pose.orientation.w = 1;
      odometry_.publish(odometry);
      camera_.send(
          toImageMessage(drawRoom(i / 50 % 3, static_cast<unsigned>(i % 20)), headerAt(stamp)));
      ASSERT_TRUE(answers.find([stamp](const auto& answer) {
        return answer.header.stamp == ros::Time(stamp);
      })) << "hour "
          << hour << ", frame " << i;
      answers.clear();
    }
    EXPECT_TRUE(eventually(
        [&] { return static_cast<int>(smoothed.messages().size()) >= kFramesAnHour - 2; }));
  }

  ros::Publisher odometry_ = node_.advertise<nav_msgs::Odometry>("/odom", 10);
};

TEST_F(Endurance, OfEightHoursTakesNoMemory) {
  const pid_t process = processOf(name_);
  ASSERT_GT(process, 0);
  double after_first = 0;
  for (int hour = 0; hour < kHours; ++hour) {
    EXPECT_TRUE(load(hour % 2 == 0 ? "three" : "two").success);
    driveAnHour(hour);
    if (HasFatalFailure()) return;
    // The first two hours see each model once, and fill the buffers.
    if (hour == 1) after_first = memoryOf(process);
  }
  const double after_last = memoryOf(process);
  RecordProperty("memory_mb", std::to_string(after_last));
  EXPECT_EQ(processOf(name_), process);
  EXPECT_LT(after_last - after_first, kMaxGrowth) << "from " << after_first << " MB";
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  using namespace place_recognition;
  return runRostest(argc, argv, "endurance_rostest", [] {
    saveRooms("two", 2);
    saveRooms("three", 3);
  });
}
