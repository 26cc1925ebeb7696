#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <place_recognition/LoadModel.h>
#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <optional>
#include <string>

#include "recognition/drawn_recording.h"
#include "ros/camera.h"
#include "ros/drawn_model.h"
#include "ros/inbox.h"

namespace place_recognition {

/// A recognizer that the launch file has started beside the test.
class RecognizerNode : public testing::Test {
 protected:
  explicit RecognizerNode(const std::string& name = "/recognizer") : name_(name) {}

  void SetUp() override { ASSERT_TRUE(load("three").success); }

  LoadModel::Response load(const std::string& model) {
    LoadModel call;
    call.request.name = model;
    EXPECT_TRUE(ros::service::waitForService(name_ + "/load_model", 15000));
    EXPECT_TRUE(ros::service::call(name_ + "/load_model", call));
    return call.response;
  }

  std_srvs::Trigger::Response trigger(const std::string& service) {
    std_srvs::Trigger call;
    EXPECT_TRUE(ros::service::call(name_ + "/" + service, call));
    return call.response;
  }

  void enable(bool on) {
    std_srvs::SetBool call;
    call.request.data = on;
    EXPECT_TRUE(ros::service::call(name_ + "/set_enabled", call));
    EXPECT_TRUE(call.response.success);
  }

  void reconfigure(const std::string& parameter, double value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(1);
    call.request.config.doubles[0].name = parameter;
    call.request.config.doubles[0].value = value;
    EXPECT_TRUE(ros::service::call(name_ + "/set_parameters", call));
  }

  std::uint32_t listeners() const {
    return name_ == "/compressed_recognizer" ? camera_.compressedListeners()
                                             : camera_.rawListeners();
  }

  /// Sends an image until it is answered. Returns the answer, or nothing if none arrives.
  std::optional<PlaceRecognition> answerTo(Inbox<PlaceRecognition>& answers, const cv::Mat& image) {
    if (!eventually([this] { return listeners() > 0; })) return std::nullopt;
    const ros::Time stamp = nextStamp();
    camera_.send(image, stamp.toSec());
    return answers.find([stamp](const auto& answer) { return answer.header.stamp == stamp; });
  }

  /// Returns the latest report named "NODE: WHAT", or nothing if none arrives.
  std::optional<diagnostic_msgs::DiagnosticStatus> status(const std::string& what) {
    Inbox<diagnostic_msgs::DiagnosticArray> inbox(node_, "/diagnostics");
    std::optional<diagnostic_msgs::DiagnosticStatus> found;
    const std::string wanted = name_.substr(1) + ": " + what;
    inbox.find([&](const diagnostic_msgs::DiagnosticArray& array) {
      for (const auto& entry : array.status) {
        if (entry.name == wanted) found = entry;
      }
      return found.has_value();
    });
    return found;
  }

  static std::string valueOf(const diagnostic_msgs::DiagnosticStatus& status,
                             const std::string& key) {
    for (const auto& pair : status.values) {
      if (pair.key == key) return pair.value;
    }
    return "missing";
  }

  /// Expects that the node subscribes to images only while `topic` has a subscriber.
  template <typename Message>
  void expectListensWith(const std::string& topic) {
    {
      const Inbox<Message> inbox(node_, name_ + topic);
      EXPECT_TRUE(eventually([this] { return listeners() == 1; })) << topic;
    }
    EXPECT_TRUE(eventually([this] { return listeners() == 0; })) << topic;
  }

  ros::Time nextStamp() {
    static double stamp = 1000;
    stamp += 1;
    return ros::Time(stamp);
  }

  ros::NodeHandle node_;
  std::string name_;
  Camera camera_{node_};
};

}  // namespace place_recognition
