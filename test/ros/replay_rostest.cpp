// Bags replayed to recognizers, one of which is killed, under simulated time. See replay.test.

#include <gtest/gtest.h>
#include <place_recognition/LoadModel.h>
#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

#include <csignal>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "base/child_process.h"
#include "recognition/drawn_recording.h"
#include "ros/bags/labelled_bag_writer.h"
#include "ros/camera.h"
#include "ros/drawn_model.h"
#include "ros/inbox.h"
#include "ros/node_process.h"
#include "ros/rostest_main.h"

namespace place_recognition {
namespace {

constexpr int kFramesOfRoom = 20;
constexpr int kFrames = 3 * kFramesOfRoom;
constexpr double kPeriod = 0.1;  // s
const char* const kFront = "/front/place_recognizer";
const char* const kRear = "/rear/place_recognizer";

std::string bag() { return std::string(std::getenv("ROS_HOME")) + "/drive.bag"; }

void writeBag() {
  LabelledBagOptions options;
  options.jpeg = false;  // JPEG would change the textures that distinguish drawn rooms
  LabelledBagWriter writer(bag(), options);
  for (const Frame& frame : drawFrames(3, kFramesOfRoom)) {
    writer.write(frame.image, frame.place, kPeriod * frame.stamp);
  }
  writer.close();
}

/// Returns the number in the bag of the frame that an answer belongs to.
int frameOf(const PlaceRecognition& answer) {
  return static_cast<int>(
      std::lround((answer.header.stamp.toSec() - LabelledBagOptions().base_time) / kPeriod));
}

/// Returns whether the model `three` gives this answer to that frame when the library is called
/// directly.
bool isRight(const PlaceRecognition& answer) {
  static const std::vector<Frame> frames = drawFrames(3, kFramesOfRoom);
  static const auto model = std::make_shared<Model>(loadModel(namedModelPath("three")));
  static Recognizer recognizer(model);
  const Recognition& expected =
      recognizer.recognize(frames[static_cast<std::size_t>(frameOf(answer))].image);
  return answer.place == model->places[static_cast<std::size_t>(expected.place)];
}

/// `rosbag play`, which runs until the end of its scope or of this program, however the program
/// ends. It is a direct child, because the script `rosbag` starts a child that may outlive it.
class Player {
 public:
  explicit Player(std::vector<std::string> options)
      : process_(arguments(std::move(options)), ChildProcess::Stderr::kDiscard) {}
  ~Player() {
    process_.interrupt();
    process_.wait();
  }

 private:
  static std::vector<std::string> arguments(std::vector<std::string> options) {
    std::vector<std::string> all = {"/usr/bin/setpriv", "--pdeathsig", "KILL",
                                    "rosrun",           "rosbag",      "play",
                                    "--quiet",          "--clock",     "--wait-for-subscribers"};
    all.insert(all.end(), options.begin(), options.end());
    all.insert(all.end(), {bag(), "--topics", "/camera/image_raw"});
    return all;
  }

  ChildProcess process_;
};

/// Simulated time may stand still, so nothing here waits for ROS time.
class Replay : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(isUp(kFront) && isUp(kRear)); }

  static bool isUp(const std::string& node) {
    std_srvs::Trigger reload;
    return eventually([&] {
      return ros::service::exists(node + "/reload_model", false) &&
             ros::service::call(node + "/reload_model", reload) && reload.response.success;
    });
  }

  ros::NodeHandle node_;
  Inbox<PlaceRecognition> answers_{node_, std::string(kFront) + "/recognition"};
};

TEST_F(Replay, OfALoopedBagFollowsItsClockBack) {
  const Inbox<std_msgs::String> places(node_, std::string(kFront) + "/place");
  const Player player({"--rate", "10", "--loop"});
  int loops = 0;
  EXPECT_TRUE(eventually([&] {
    loops = 0;
    const auto answers = answers_.messages();
    for (std::size_t i = 1; i < answers.size(); ++i) {
      loops += answers[i].header.stamp < answers[i - 1].header.stamp;
    }
    return loops >= 2;
  })) << loops;
  for (const PlaceRecognition& answer : answers_.messages()) {
    EXPECT_TRUE(isRight(answer)) << frameOf(answer) << " " << answer.place;
  }
  // The place over time restarts with each loop and follows the rooms in order.
  std::string rooms;
  for (const std_msgs::String& place : places.messages()) {
    if (place.data != "unknown") rooms += place.data.back();
  }
  EXPECT_NE(rooms.find("0120"), std::string::npos) << rooms;
}

TEST_F(Replay, AtTenTimesTheRateAnswersEachFrameOnceAndTheNewestAlways) {
  ASSERT_TRUE(eventually([this] { return answers_.connected(); }));
  const Player player({"--rate", "10"});
  EXPECT_TRUE(answers_.find([](const auto& answer) { return frameOf(answer) == kFrames - 1; }));
  int last = -1;
  for (const PlaceRecognition& answer : answers_.messages()) {
    EXPECT_GT(frameOf(answer), last);
    EXPECT_TRUE(isRight(answer)) << frameOf(answer) << " " << answer.place;
    last = frameOf(answer);
  }
  // A busy machine may skip some frames; an idle one skips none.
  EXPECT_GT(answers_.messages().size(), static_cast<std::size_t>(kFrames / 2));
}

TEST_F(Replay, WhileModelsAreReplacedNamesTheModelOfEachAnswer) {
  const Player player({"--rate", "3"});
  int loads = 0;
  const bool complete = eventually([&] {
    LoadModel call;
    call.request.name = loads % 3 == 0 ? "two" : loads % 3 == 1 ? "three" : "missing";
    EXPECT_TRUE(ros::service::call(std::string(kFront) + "/load_model", call));
    EXPECT_EQ(call.response.success, loads % 3 != 2);
    ++loads;
    const auto answers = answers_.messages();
    return !answers.empty() && frameOf(answers.back()) == kFrames - 1;
  });
  EXPECT_TRUE(complete);
  std::map<std::string, std::set<std::string>> versions;  // by the name of the model
  for (const PlaceRecognition& answer : answers_.messages()) {
    versions[answer.model_name].insert(answer.model_version);
    ASSERT_EQ(answer.places.size(), answer.model_name == "two" ? 2u : 3u);
    EXPECT_TRUE(answer.model_name == "two" || isRight(answer));
  }
  EXPECT_EQ(versions.size(), 2u) << loads << " loads";
  for (const auto& [model, of_model] : versions) EXPECT_EQ(of_model.size(), 1u) << model;
  EXPECT_GT(answers_.messages().size(), static_cast<std::size_t>(kFrames / 2));
  LoadModel back;
  back.request.name = "three";
  EXPECT_TRUE(ros::service::call(std::string(kFront) + "/load_model", back));
}

TEST_F(Replay, GoesOnAfterTheRecognizerWasKilled) {
  const Player player({"--rate", "1", "--loop"});
  ASSERT_TRUE(answers_.find([](const auto&) { return true; }));
  const pid_t killed = processOf(kFront);
  ASSERT_GT(killed, 0);
  ASSERT_EQ(kill(killed, SIGKILL), 0);
  EXPECT_TRUE(eventually([&] {
    const pid_t now = processOf(kFront);
    return now > 0 && now != killed;
  }));
  answers_.clear();
  const auto answer = answers_.find([](const auto&) { return true; });
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->model_name, "three");
  EXPECT_TRUE(isRight(*answer));
}

TEST_F(Replay, TwoRecognizersInTwoNamespacesHaveEachTheirModel) {
  Inbox<PlaceRecognition> rear_answers(node_, std::string(kRear) + "/recognition");
  Camera rear(node_, "/rear/rear_camera");
  ASSERT_TRUE(eventually([&] { return rear.rawListeners() > 0; }));
  const Player player({"--rate", "10"});
  EXPECT_TRUE(answers_.find([](const auto& answer) { return frameOf(answer) == kFrames - 1; }));
  rear.send(drawRoom(1, 7), 5000);
  const auto answer = rear_answers.find([](const auto&) { return true; });
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->header.stamp, ros::Time(5000));
  EXPECT_EQ(answer->model_name, "two");
  EXPECT_EQ(answer->place, "room1");
  EXPECT_EQ(rear_answers.messages().size(), 1u);
  for (const PlaceRecognition& front : answers_.messages()) EXPECT_EQ(front.model_name, "three");
}

}  // namespace

}  // namespace place_recognition

int main(int argc, char** argv) {
  using namespace place_recognition;
  return runRostest(argc, argv, "replay_rostest", [] {
    saveRooms("two", 2);
    saveRooms("three", 3);
    writeBag();
  });
}
