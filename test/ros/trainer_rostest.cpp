// trainer from outside: the action, the service, refused goals. See trainer.test.

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <place_recognition/ModelInfo.h>
#include <place_recognition/Retrain.h>
#include <place_recognition/TrainAction.h>
#include <ros/ros.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"
#include "ros/bags/labelled_bag_writer.h"
#include "ros/inbox.h"
#include "ros/rostest_main.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

const char* const kYaml =
    "cues:\n"
    "  - feature: {type: crfh, descriptors: [L, Lxx], scales: [1], bins: [8]}\n";

std::string home() { return std::getenv("ROS_HOME"); }

void writeBag(const std::string& path, int count, unsigned first_frame = 0) {
  LabelledBagWriter writer(path);
  for (const Frame& frame : drawFrames(3, count, first_frame))
    writer.write(frame.image, frame.place, frame.stamp);
  writer.close();
}

using Client = actionlib::SimpleActionClient<TrainAction>;

class Trainers : public testing::Test {
 protected:
  Trainers() {
    EXPECT_TRUE(client_.waitForServer(ros::Duration(30)));
    EXPECT_TRUE(ros::service::waitForService("/trainer/retrain", 15000));
  }

  static TrainGoal goal(const std::string& model, const std::string& bag = "short.bag") {
    TrainGoal goal;
    goal.bags = {bag};
    goal.model = model;
    goal.yaml = kYaml;
    return goal;
  }

  static Retrain::Response retrain(const std::function<void(Retrain::Request&)>& change) {
    Retrain call;
    call.request.bags = {"short.bag"};
    call.request.model = "retrained";
    call.request.yaml = kYaml;
    change(call.request);
    EXPECT_TRUE(ros::service::call("/trainer/retrain", call));
    return call.response;
  }

  /// Starts a long training and waits until it is running.
  void startLong() {
    client_.sendGoal(goal("cancelled", "long.bag"), Client::SimpleDoneCallback(),
                     Client::SimpleActiveCallback(),
                     [this](const TrainFeedbackConstPtr&) { ++feedbacks_; });
    ASSERT_TRUE(eventually([this] { return feedbacks_ > 0; }, 60));
  }

  std::atomic<int> feedbacks_{0};
  ros::NodeHandle node_;
  Client client_{"/trainer/train", false};
};

TEST_F(Trainers, TrainWithFeedbackAndReloadRecognizers) {
  Inbox<ModelInfo> infos(node_, "/place_recognizer/model_info");
  std::atomic<bool> sound{true};
  TrainGoal wanted = goal("home");
  wanted.recognizers = {"/place_recognizer", "/nobody"};
  client_.sendGoal(wanted, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                   [&](const TrainFeedbackConstPtr& feedback) {
                     ++feedbacks_;
                     if (feedback->stage.empty() || feedback->message.empty() ||
                         feedback->fraction < 0 || feedback->fraction > 1) {
                       sound = false;
                     }
                   });
  ASSERT_TRUE(client_.waitForResult(ros::Duration(120)));
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::SUCCEEDED);
  const TrainResultConstPtr result = client_.getResult();
  EXPECT_TRUE(result->success);
  EXPECT_EQ(result->images, 60u);
  EXPECT_EQ(result->places, (std::vector<std::string>{"room0", "room1", "room2"}));
  EXPECT_GT(result->support_vectors, 0u);
  EXPECT_GT(result->validation_rate, 0.5);
  EXPECT_GT(result->seconds, 0);
  EXPECT_NE(result->message.find("/place_recognizer has loaded it"), std::string::npos)
      << result->message;
  EXPECT_NE(result->message.find("/nobody has not loaded it"), std::string::npos);
  EXPECT_TRUE(infos.find([](const ModelInfo& info) { return info.name == "home"; }));
  EXPECT_EQ(loadModel(namedModelPath("home")).places.size(), 3u);
  EXPECT_GT(feedbacks_, 0);
  EXPECT_TRUE(sound);
}

TEST_F(Trainers, CancelLeavesNothingBehind) {
  startLong();
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(ros::Duration(30)));
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::PREEMPTED);
  EXPECT_FALSE(client_.getResult()->success);
  for (const auto& file : fs::directory_iterator(modelFolder())) {
    EXPECT_EQ(file.path().filename().string().find("cancelled"), std::string::npos) << file;
  }
}

/// The trainer's threads handle a goal and its cancel at the same time; few rounds meet the moment
/// between them. A SimpleActionClient cannot cancel a goal that the server may not know yet.
TEST_F(Trainers, CancelBehindItsGoalStopsTheTraining) {
  using actionlib_msgs::GoalStatus;
  Inbox<TrainActionResult> results(node_, "/trainer/train/result");
  ros::Publisher goals = node_.advertise<TrainActionGoal>("/trainer/train/goal", 1);
  ros::Publisher cancels = node_.advertise<actionlib_msgs::GoalID>("/trainer/train/cancel", 1);
  ASSERT_TRUE(eventually([&] {
    return goals.getNumSubscribers() > 0 && cancels.getNumSubscribers() > 0 && results.connected();
  }));
  for (int i = 0; i < 10; ++i) {
    TrainActionGoal wanted;
    wanted.goal = goal("cancelled");
    wanted.goal_id.id = "overtaken " + std::to_string(i);
    goals.publish(wanted);
    cancels.publish(wanted.goal_id);
    const auto result = results.find([&](const TrainActionResult& message) {
      return message.status.goal_id.id == wanted.goal_id.id;
    });
    ASSERT_TRUE(result) << i;
    EXPECT_TRUE(result->status.status == GoalStatus::PREEMPTED ||
                result->status.status == GoalStatus::RECALLED)
        << result->status;
  }
}

TEST_F(Trainers, RefuseASecondTrainingMeanwhile) {
  startLong();
  Client second("/trainer/train", false);
  ASSERT_TRUE(second.waitForServer(ros::Duration(15)));
  second.sendGoal(goal("second"));
  ASSERT_TRUE(second.waitForResult(ros::Duration(15)));
  EXPECT_EQ(second.getState(), actionlib::SimpleClientGoalState::REJECTED);
  EXPECT_NE(second.getResult()->message.find("Another training"), std::string::npos);
  const Retrain::Response response = retrain([](Retrain::Request&) {});
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("Another training"), std::string::npos);
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(ros::Duration(30)));
  EXPECT_TRUE(retrain([](Retrain::Request&) {}).success);
}

TEST_F(Trainers, RetrainByService) {
  const Retrain::Response response = retrain([](Retrain::Request& request) {
    request.reduction = "none";
    request.recognizers = {"/place_recognizer"};
  });
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.places.size(), 3u);
  EXPECT_EQ(response.images, 60u);
  EXPECT_NE(response.message.find("has loaded it"), std::string::npos);
}

TEST_F(Trainers, SayHowTheModelDoesOnTheBagsToValidateOn) {
  const Retrain::Response response =
      retrain([](Retrain::Request& request) { request.validate = {"later.bag"}; });
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_NE(response.message.find(" % on validate."), std::string::npos) << response.message;
}

TEST_F(Trainers, LearnOnWithinALimit) {
  ASSERT_TRUE(retrain([](Retrain::Request&) {}).success);
  const Retrain::Response response = retrain([](Retrain::Request& request) {
    request.yaml.clear();
    request.add_to = request.model;
    request.vector_limit = 12;
  });
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_LE(response.support_vectors, 12u);
}

TEST_F(Trainers, CalibrateAModel) {
  ASSERT_TRUE(retrain([](Retrain::Request&) {}).success);
  const std::string path = namedModelPath("retrained");
  const Model before = loadModel(path);
  const auto calibrate = [](const std::string& bag) {
    return retrain([&bag](Retrain::Request& request) {
      request.yaml.clear();
      request.calibrate = true;
      request.bags = {bag};
      request.recognizers = {"/place_recognizer"};
    });
  };
  const Retrain::Response response = calibrate("other.bag");
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_EQ(response.images, 90u);
  EXPECT_GT(response.validation_rate, 0.5);
  EXPECT_NE(response.message.find("calibration error"), std::string::npos) << response.message;
  EXPECT_NE(response.message.find("has loaded it"), std::string::npos) << response.message;
  const Model after = loadModel(path);
  EXPECT_NE(after.version, before.version);
  EXPECT_NE(after.calibration.slope, before.calibration.slope);
  EXPECT_EQ(after.supportVectorCount(), before.supportVectorCount());
  EXPECT_EQ(after.places, before.places);
  EXPECT_FALSE(calibrate("missing.bag").success);
  EXPECT_EQ(loadModel(path).version, after.version);
}

TEST_F(Trainers, CalibrateByActionWithFeedback) {
  ASSERT_TRUE(retrain([](Retrain::Request&) {}).success);
  TrainGoal wanted = goal("retrained", "other.bag");
  wanted.yaml.clear();
  wanted.calibrate = true;
  client_.sendGoal(wanted, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                   [this](const TrainFeedbackConstPtr&) { ++feedbacks_; });
  ASSERT_TRUE(client_.waitForResult(ros::Duration(120)));
  EXPECT_EQ(client_.getState(), actionlib::SimpleClientGoalState::SUCCEEDED);
  EXPECT_EQ(client_.getResult()->images, 90u);
  EXPECT_GT(feedbacks_, 0);
}

TEST_F(Trainers, SayWhatIsWrongWithAGoal) {
  using Request = Retrain::Request;
  const auto expectRefused = [](const std::string& reason,
                                const std::function<void(Request&)>& change) {
    const Retrain::Response response = retrain(change);
    EXPECT_FALSE(response.success);
    EXPECT_EQ(response.message.find("place_tool train: "), std::string::npos) << response.message;
    EXPECT_NE(response.message.find(reason), std::string::npos) << response.message;
  };
  expectRefused("model", [](Request& r) { r.model = "../home"; });
  expectRefused("not a bag", [](Request& r) { r.bags = {"/etc/passwd"}; });
  expectRefused("does not exist", [](Request& r) { r.bags = {"missing.bag"}; });
  expectRefused("not a bag", [](Request& r) { r.bags = {"../short.bag"}; });
  expectRefused("not a bag", [](Request& r) { r.bags = {std::string("short.bag\0.bag", 14)}; });
  expectRefused("not a bag", [](Request& r) { r.bags = {std::string(1 << 20, 'a') + ".bag"}; });
  expectRefused("model", [](Request& r) { r.model = std::string("home\0", 5); });
  expectRefused("model", [](Request& r) { r.model = std::string(1 << 20, 'a'); });
  expectRefused("bags", [](Request& r) { r.bags.clear(); });
  expectRefused("bags", [](Request& r) { r.bags.resize(1001, "short.bag"); });
  expectRefused("yaml", [](Request& r) { r.yaml = std::string(1 << 20, ' '); });
  expectRefused("alias", [](Request& r) { r.yaml = "svm: &a {c: 1}\nimage: *a"; });
  expectRefused("colour", [](Request& r) { r.yaml = "colour: true"; });
  expectRefused("use one of: local-match", [](Request& r) {
    r.yaml = "cues: [{name: a, feature: {type: harris-laplace-sift}, kernel: {type: linear}}]";
  });
  expectRefused("nosuchpreset", [](Request& r) { r.yaml.clear(), r.preset = "nosuchpreset"; });
  expectRefused("/front", [](Request& r) { r.image_topic = "/front"; });
  expectRefused("validate: ", [](Request& r) { r.validate = r.bags; });
  expectRefused("everywhere", [](Request& r) { r.label = "everywhere"; });  // a single place
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  using namespace place_recognition;
  return runRostest(argc, argv, "trainer_rostest", [] {
    std::filesystem::create_directories(modelFolder());
    writeBag(home() + "/short.bag", 20);
    writeBag(home() + "/other.bag", 30);
    writeBag(home() + "/long.bag", 1500);
    writeBag(home() + "/later.bag", 10, 5000);
  });
}
