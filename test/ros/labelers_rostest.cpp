// Runs recorded by place_labeler and auto_labeler, from the first image to a model trained on them.
// See labelers.test for the nodes. The tests follow the order of a recording.

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <place_recognition/Retrain.h>
#include <place_recognition/SayPlace.h>
#include <ros/ros.h>
#include <sensor_msgs/Joy.h>
#include <std_msgs/String.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "recognition/drawn_recording.h"
#include "ros/bags/bag_recording.h"
#include "ros/camera.h"
#include "ros/inbox.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// Shared by both tests, because roscpp is slow to reconnect to a topic that was closed and
/// reopened.
std::unique_ptr<Camera> camera;

std::string home() { return std::getenv("ROS_HOME"); }

/// Ends a node as Ctrl-C and roslaunch do, and waits for its bag.
void endNode(const std::string& node, const std::string& bag) {
  EXPECT_EQ(std::system(("rosnode kill " + node + " >/dev/null").c_str()), 0);
  EXPECT_TRUE(eventually([&bag] { return fs::exists(bag); }));
  EXPECT_FALSE(fs::exists(bag + ".active"));
}

void expectTrains(const std::string& bag, const std::string& label_topic) {
  Retrain call;
  call.request.bags = {bag};
  call.request.label_topic = label_topic;
  call.request.model = "labelled";
  call.request.yaml =
      "cues: [{feature: {type: crfh, descriptors: [L, Lxx], scales: [1], bins: [8]}}]";
  ASSERT_TRUE(ros::service::waitForService("/trainer/retrain", 15000));
  ASSERT_TRUE(ros::service::call("/trainer/retrain", call));
  EXPECT_TRUE(call.response.success) << call.response.message;
  EXPECT_EQ(call.response.places, (std::vector<std::string>{"room0", "room1", "room2"}));
  EXPECT_GT(call.response.validation_rate, 0.8);
}

class PlaceLabelers : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(eventually([this] { return camera_.compressedListeners() > 0; }));
    ASSERT_TRUE(eventually([this] { return joy_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(eventually([this] { return say_.getNumSubscribers() > 0; }));
    ASSERT_TRUE(ros::service::waitForService("/place_labeler/say", 15000));
  }

  /// Sends images of a room once `label` has been heard. All have arrived when it returns.
  void drive(int room, const std::string& label) {
    ASSERT_TRUE(
        labels_.find([&](const std_msgs::String& message) { return message.data == label; }));
    for (unsigned i = 0; i < 12; ++i) {
      camera_.send(drawRoom(room, i), ros::Time::now().toSec());
      ros::WallDuration(0.02).sleep();
    }
    ros::WallDuration(0.5).sleep();
  }

  SayPlace::Response say(const std::string& place) {
    SayPlace call;
    call.request.place = place;
    EXPECT_TRUE(ros::service::call("/place_labeler/say", call));
    return call.response;
  }

  void press(int button) {
    sensor_msgs::Joy joy;
    joy.buttons.resize(4);
    joy_.publish(joy);
    joy.buttons[static_cast<std::size_t>(button)] = 1;
    joy_.publish(joy);
  }

  ros::NodeHandle node_;
  Camera& camera_ = *camera;
  ros::Publisher joy_ = node_.advertise<sensor_msgs::Joy>("/joy", 10);
  ros::Publisher say_ = node_.advertise<std_msgs::String>("/place_labeler/say", 10);
  Inbox<std_msgs::String> labels_{node_, "/place_label"};
};

TEST_F(PlaceLabelers, RecordWhatIsSaidByServiceTopicAndButton) {
  const std::string bag = home() + "/said.bag";
  EXPECT_TRUE(fs::exists(bag + ".active"));
  EXPECT_TRUE(say("room0").success);
  drive(0, "room0");
  std_msgs::String spoken;
  spoken.data = "room1";
  say_.publish(spoken);
  drive(1, "room1");
  EXPECT_TRUE(say("").success);
  labels_.clear();
  press(2);
  drive(2, "room2");
  for (const std::string bad : {"unknown", "a\nb"}) {
    const SayPlace::Response refused = say(bad);
    EXPECT_FALSE(refused.success);
    EXPECT_GT(refused.message.size(), 20u);
  }
  EXPECT_FALSE(fs::exists(bag));
  endNode("/place_labeler", bag);

  const auto recording = openBagRecording(bag);
  Frame frame;
  int frames = 0;
  for (; recording->next(frame); ++frames) {
    EXPECT_EQ(frame.place, "room" + std::to_string(frames / 12)) << frame.name;
    EXPECT_FALSE(frame.image.empty());
  }
  EXPECT_EQ(frames, 36);
  expectTrains(bag, "");
}

class AutoLabelers : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(eventually([this] { return camera_.rawListeners() > 0; }));
    ASSERT_TRUE(eventually([this] { return pose_.getNumSubscribers() > 0; }));
  }

  /// Sends an image taken at (x, 2) and, as robots do, the pose slightly later.
  void visit(double x, int room, unsigned number) {
    geometry_msgs::TransformStamped transform;
    transform.header = headerAt(ros::Time::now().toSec());  // rounded like the image's stamp
    transform.header.frame_id = "map";
    transform.child_frame_id = "base_link";
    transform.transform.translation.x = x;
    transform.transform.translation.y = 2;
    transform.transform.rotation.w = 1;
    camera_.send(drawRoom(room, number), transform.header.stamp.toSec());
    ros::WallDuration(0.03).sleep();
    transforms_.sendTransform(transform);
    labelled_stamp_ = transform.header.stamp.toSec();
  }

  /// The last label heard; "none" before the first.
  std::string lastLabel() {
    const auto messages = labels_.messages();
    return messages.empty() ? "none" : messages.back().data;
  }

  void setDeviation(double metres) {
    geometry_msgs::PoseWithCovarianceStamped pose;
    pose.pose.covariance[0] = pose.pose.covariance[7] = metres * metres;
    pose_.publish(pose);
    ros::WallDuration(0.3).sleep();
  }

  ros::NodeHandle node_;
  Camera& camera_ = *camera;
  tf2_ros::TransformBroadcaster transforms_;
  ros::Publisher pose_ =
      node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("/amcl_pose", 10);
  Inbox<std_msgs::String> labels_{node_, "/auto_label"};
  double labelled_stamp_ = 0;  // of the last visit, s
};

TEST_F(AutoLabelers, RecordWhereTheRobotWasWhenTheImageWasTaken) {
  const std::string bag = home() + "/located.bag";
  visit(2, 0, 0);  // tf may not have connected yet
  ASSERT_TRUE(eventually([this] {
    visit(2, 0, 0);
    return lastLabel() == "room0";
  }));
  const ros::Time begin = ros::Time::now();
  for (int room = 0; room < 3; ++room) {
    for (unsigned i = 1; i <= 10; ++i) visit(4 * room + 0.5 + 0.3 * i, room, i);
    EXPECT_TRUE(eventually([&] { return lastLabel() == "room" + std::to_string(room); }));
    visit(4 * room + 3.8, room, 20);  // the doorway
    EXPECT_TRUE(eventually([this] { return lastLabel().empty(); }));
  }
  setDeviation(0.8);
  for (unsigned i = 0; i < 5; ++i) visit(2, 0, 21 + i);
  EXPECT_TRUE(lastLabel().empty()) << "an uncertain pose labels nothing";
  setDeviation(0.1);
  EXPECT_TRUE(eventually([this] {
    visit(2, 0, 26);
    return lastLabel() == "room0";
  }));
  const double standing = labelled_stamp_;  // a driver that gives all images the same stamp
  for (int i = 0; i < 15; ++i) {
    camera_.send(drawRoom(0, 26), standing);
    ros::WallDuration(0.1).sleep();
  }
  EXPECT_TRUE(eventually([this] { return lastLabel().empty(); }));
  EXPECT_TRUE(eventually([this] {
    visit(2, 0, 26);
    return lastLabel() == "room0";
  }));
  camera_.send(drawRoom(0, 27), ros::Time::now().toSec() + 100);  // no pose for that time
  EXPECT_TRUE(eventually([this] { return lastLabel().empty(); }));
  geometry_msgs::TransformStamped impossible;  // a time that ROS cannot calculate with
  impossible.header.frame_id = "map";
  impossible.header.stamp = ros::Time(std::numeric_limits<std::uint32_t>::max(), 0);
  impossible.child_frame_id = "base_link";
  impossible.transform.rotation.w = 1;
  transforms_.sendTransform(impossible);
  ros::WallDuration(0.5).sleep();
  endNode("/auto_labeler", bag);

  BagRecordingOptions options;
  options.label_topic = "/auto_label";
  const auto recording = openBagRecording(bag, options);
  std::vector<std::string> labels;  // one per stretch of frames
  std::vector<int> lengths;
  for (Frame frame; recording->next(frame);) {
    if (frame.stamp < begin.toSec()) continue;
    if (labels.empty() || labels.back() != frame.place) {
      labels.push_back(frame.place);
      lengths.push_back(0);
    }
    ++lengths.back();
  }
  EXPECT_EQ(labels, (std::vector<std::string>{"room0", "", "room1", "", "room2", "", "room0", "",
                                              "room0", ""}));
  ASSERT_GE(lengths.size(), 5u);
  lengths.resize(5);  // the number of later visits depends on the waits
  EXPECT_EQ(lengths, (std::vector<int>{10, 1, 10, 1, 10}));
  expectTrains(bag, "/auto_label");
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "labelers_rostest");
  ros::NodeHandle node;
  place_recognition::camera = std::make_unique<place_recognition::Camera>(node);
  ros::AsyncSpinner spinner(2);
  spinner.start();
  const int result = RUN_ALL_TESTS();
  place_recognition::camera.reset();
  return result;
}
