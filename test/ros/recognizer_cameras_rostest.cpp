// place_recognizer with several cameras.

#include <rosgraph_msgs/Log.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>

#include <functional>
#include <opencv2/core.hpp>
#include <string>

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

class RecognizerOfCameras : public RecognizerNode {
 protected:
  explicit RecognizerOfCameras(const std::string& name = "/cameras_recognizer")
      : RecognizerNode(name) {}

  void SetUp() override {
    ASSERT_TRUE(load("three").success);
    ASSERT_TRUE(
        eventually([this] { return front_.rawListeners() > 0 && rear_.rawListeners() > 0; }));
  }

  /// Sends frames at 10 Hz, with stamps at the same rate, until `done`.
  bool sendUntil(const std::function<cv::Mat(unsigned)>& front,
                 const std::function<cv::Mat(unsigned)>& rear, const std::function<bool()>& done) {
    for (int i = 0; i < 150 && !done(); ++i) {
      stamp_ += 0.1;
      const unsigned frame = ++frame_;
      if (front) front_.send(front(frame), stamp_);
      if (rear) rear_.send(rear(frame), stamp_);
      ros::WallDuration(0.1).sleep();
    }
    return done();
  }

  std::string lastPlace() const {
    const auto messages = places_.messages();
    return messages.empty() ? "" : messages.back().data;
  }

  /// Returns the message of the latest report named "NODE: WHAT"; empty if there is none.
  std::string reported(const std::string& what) const {
    std::string message;
    for (const diagnostic_msgs::DiagnosticArray& array : reports_.messages()) {
      for (const auto& report : array.status) {
        if (report.name == name_.substr(1) + ": " + what) message = report.message;
      }
    }
    return message;
  }

  /// Returns the value of `key` in the latest report on `what`.
  std::string value(const std::string& what, const std::string& key) const {
    std::string value;
    for (const diagnostic_msgs::DiagnosticArray& array : reports_.messages()) {
      for (const auto& report : array.status) {
        if (report.name != name_.substr(1) + ": " + what) continue;
        for (const auto& entry : report.values) {
          if (entry.key == key) value = entry.value;
        }
      }
    }
    return value;
  }

  static std::function<cv::Mat(unsigned)> showing(int room) {
    return [room](unsigned frame) { return drawRoom(room, 1000 + frame); };
  }

  Camera front_{node_, "/front/image_raw"};
  Camera rear_{node_, "/rear/image"};
  Inbox<PlaceRecognition> answers_{node_, name_ + "/recognition"};
  Inbox<std_msgs::String> places_{node_, name_ + "/place"};
  Inbox<diagnostic_msgs::DiagnosticArray> reports_{node_, "/diagnostics"};
  double stamp_ = 5000;
  unsigned frame_ = 0;
};

TEST_F(RecognizerOfCameras, AnswersEachAndJoinsThemInOnePlace) {
  const auto from = [this](const std::string& camera) {
    for (const PlaceRecognition& answer : answers_.messages()) {
      if (answer.camera == camera && answer.place == "room1") return true;
    }
    return false;
  };
  EXPECT_TRUE(sendUntil(showing(1), showing(1), [&] {
    return from("front") && from("rear/image") && lastPlace() == "room1";
  }));
  // A single camera is enough to change the room.
  EXPECT_TRUE(sendUntil(nullptr, showing(2), [&] { return lastPlace() == "room2"; }));
}

TEST_F(RecognizerOfCameras, OneThatShowsNothingIsNamedAndDoesNotCount) {
  const cv::Mat black = drawRoom(0, 1) * 0;
  ASSERT_TRUE(sendUntil(showing(1), showing(1), [&] { return lastPlace() == "room1"; }));
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(3);
  places_.clear();
  sendUntil(
      showing(1), [&](unsigned) { return black; }, [&] { return ros::WallTime::now() > end; });
  EXPECT_TRUE(places_.messages().empty()) << lastPlace();
  EXPECT_NE(reported("Images of rear/image").find("black"), std::string::npos);
  // By itself it provides no evidence, so without the other one the place becomes unknown.
  EXPECT_TRUE(sendUntil(
      nullptr, [&](unsigned) { return black; }, [&] { return lastPlace() == "unknown"; }));
}

TEST_F(RecognizerOfCameras, OneThatIsSilentIsNamedAndTheOtherContinues) {
  ASSERT_TRUE(sendUntil(showing(0), showing(0), [&] { return lastPlace() == "room0"; }));
  places_.clear();
  EXPECT_TRUE(sendUntil(nullptr, showing(0), [&] {
    return reported("Images of front").find("no image on /front/image_raw") != std::string::npos;
  })) << reported("Images of front");
  EXPECT_TRUE(sendUntil(nullptr, showing(2), [&] { return lastPlace() == "room2"; }));
}

TEST_F(RecognizerOfCameras, AreEachNamedIfTheirImagesCannotBeUsed) {
  const Inbox<rosgraph_msgs::Log> log(node_, "/rosout");
  const auto is_named = [&](const std::string& topic) {
    for (const rosgraph_msgs::Log& entry : log.messages()) {
      const std::string warning = "An image on " + topic + " cannot be used";
      if (entry.name == name_ && entry.msg.find(warning) == 0) return true;
    }
    return false;
  };
  EXPECT_TRUE(eventually([&] {
    stamp_ += 0.1;
    sensor_msgs::Image distances = toImageMessage(drawRoom(0, 1), headerAt(stamp_));
    distances.encoding = "32FC1";
    front_.send(distances);
    rear_.send(distances);
    return is_named("/front/image_raw") && is_named("/rear/image");
  }));
}

TEST_F(RecognizerOfCameras, TellHowTheirImagesDifferFromTheTraining) {
  ASSERT_TRUE(sendUntil(showing(0), showing(1), [&] {
    return !value("Images of front", "shift of the evidence").empty();
  }));
  EXPECT_EQ(value("Images of front", "gains to the light of the training: red, green, blue"),
            "1.00, 1.00, 1.00");  // no cue of this model follows the light
}

TEST_F(RecognizerOfCameras, HaveADebugImageEach) {
  Inbox<sensor_msgs::Image> front(node_, name_ + "/front/debug_image");
  Inbox<sensor_msgs::Image> rear(node_, name_ + "/rear/image/debug_image");
  EXPECT_TRUE(sendUntil(showing(0), showing(1),
                        [&] { return !front.messages().empty() && !rear.messages().empty(); }));
}

class RecognizerOfModels : public RecognizerOfCameras {
 protected:
  RecognizerOfModels() : RecognizerOfCameras("/models_recognizer") {}
  void SetUp() override {
    // The node may have started before its models were there.
    ASSERT_TRUE(ros::service::waitForService(name_ + "/reload_model", 15000));
    ASSERT_TRUE(trigger("reload_model").success);
  }
};

TEST_F(RecognizerOfModels, AnswerTheirCameraAndCountIfTheyKnowTheSamePlaces) {
  const auto modelOf = [this](const std::string& camera) {
    std::string model;
    for (const PlaceRecognition& answer : answers_.messages()) {
      if (answer.camera == camera) model = answer.model_name;
    }
    return model;
  };
  EXPECT_TRUE(sendUntil(showing(0), showing(1),
                        [&] {
                          return modelOf("front") == "three" && modelOf("rear/image") == "two" &&
                                 lastPlace() == "room0";
                        }))
      << modelOf("front") << " " << modelOf("rear/image") << " " << lastPlace();
  const std::string why = "the places of its model two differ from those of three";
  EXPECT_TRUE(sendUntil(showing(0), showing(1), [&] {
    return reported("Images of rear/image").find(why) != std::string::npos;
  })) << reported("Images of rear/image");
  EXPECT_EQ(reported("Model of front"), "three");
  EXPECT_EQ(reported("Model of rear/image"), "two");
  ASSERT_TRUE(load("three").success);
  EXPECT_TRUE(sendUntil(nullptr, showing(1), [&] { return lastPlace() == "room1"; }));
  EXPECT_EQ(modelOf("rear/image"), "three");
}

}  // namespace
}  // namespace place_recognition
