// Two recognizers with two cameras, under load and concurrent commands; see stress.test.

#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <place_recognition/LoadModel.h>
#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <random>
#include <thread>
#include <vector>

#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"
#include "reliability/image_messages.h"
#include "reliability/other_process.h"
#include "ros/drawn_model.h"
#include "ros/inbox.h"
#include "ros/messages/conversions.h"
#include "ros/rostest_main.h"
#include "rounds.h"

namespace place_recognition {
namespace {

const std::vector<std::string> kNames = {"left", "right"};

std_msgs::Header headerAt(double stamp) {
  std_msgs::Header header;
  header.stamp = ros::Time(stamp);
  return header;
}

sensor_msgs::CompressedImage compress(const cv::Mat& image, const std_msgs::Header& header) {
  sensor_msgs::CompressedImage message;
  message.header = header;
  cv::imencode(".jpg", image, message.data);
  return message;
}

/// Counts the messages of a recognizer. Does not store them, because hours of load would fill the
/// memory.
class Answers {
 public:
  Answers(ros::NodeHandle& node, const std::string& name) {
    const boost::function<void(const PlaceRecognitionConstPtr&)> receive =
        [this](const PlaceRecognitionConstPtr& answer) {
          ++count_;
          newest_ = answer->header.stamp.toSec();
          if (!isSound(*answer)) ++unsound_;
        };
    subscriber_ = node.subscribe<PlaceRecognition>("/" + name + "/recognition", 1000, receive);
  }

  int count() const { return count_; }
  int unsound() const { return unsound_; }
  double newest() const { return newest_; }

 private:
  static bool isSound(const PlaceRecognition& answer) {
    double sum = 0;
    bool finite = std::isfinite(answer.confidence) && std::isfinite(answer.evidence) &&
                  std::isfinite(answer.seconds);
    for (const PlaceScore& score : answer.places) {
      finite = finite && std::isfinite(score.margin) && std::isfinite(score.probability);
      sum += score.probability;
    }
    return finite && std::abs(sum - 1) < 1e-6 &&
           (answer.model_name == "two") == (answer.places.size() == 2);
  }

  std::atomic<int> count_{0}, unsound_{0};
  std::atomic<double> newest_{0};
  ros::Subscriber subscriber_;
};

class Stress : public testing::Test {
 protected:
  Stress() {
    for (const std::string& name : kNames) {
      EXPECT_TRUE(ros::service::waitForService("/" + name + "/load_model", 30000));
      EXPECT_TRUE(load(name, "three"));
    }
    EXPECT_TRUE(eventually(
        [this] { return left_.getNumSubscribers() > 0 && right_.getNumSubscribers() > 0; }));
  }

  static bool load(const std::string& recognizer, const std::string& model) {
    LoadModel call;
    call.request.name = model;
    return ros::service::call("/" + recognizer + "/load_model", call) && call.response.success;
  }

  /// Calls a service. roscpp occasionally loses one call in thousands, even to a server that only
  /// answers: it closes a connection that the server has closed before reading the answer from it
  /// (ros_comm issue 1976). The next call must succeed.
  template <typename Call>
  static bool answers(const std::string& service, Call& call) {
    for (int attempt = 0; attempt < 3; ++attempt) {
      if (ros::service::call(service, call)) return true;
    }
    return false;
  }

  static void trigger(const std::string& recognizer, const std::string& service) {
    std_srvs::Trigger call;
    EXPECT_TRUE(answers("/" + recognizer + "/" + service, call)) << service;
  }

  static void enable(const std::string& recognizer, bool on) {
    std_srvs::SetBool call;
    call.request.data = on;
    EXPECT_TRUE(answers("/" + recognizer + "/set_enabled", call));
  }

  static void reconfigure(const std::string& recognizer, const std::string& key, double value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(1);
    call.request.config.doubles[0].name = key;
    call.request.config.doubles[0].value = value;
    EXPECT_TRUE(answers("/" + recognizer + "/set_parameters", call));
  }

  void send(const cv::Mat& image, double stamp) {
    left_.publish(toImageMessage(image, headerAt(stamp)));
    right_.publish(compress(image, headerAt(stamp)));
  }

  /// Sends images at 200 Hz until the time is over, one in ten of them damaged. The stamps come
  /// from a clock that sometimes jumps, and are sometimes missing.
  void sendFor(double seconds) {
    ImageMessages bad(3);
    std::mt19937 random(4);
    std::vector<cv::Mat> images;
    for (unsigned i = 0; i < 30; ++i) images.push_back(drawRoom(static_cast<int>(i % 3), i));
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
    double stamp = 1e6;
    ros::WallRate rate(200);
    for (std::size_t i = 0; ros::WallTime::now() < end; ++i, rate.sleep()) {
      stamp += 0.005;
      if (random() % 500 == 0) stamp = 1 + static_cast<double>(random() % 4000000000u);
      send(images[i % images.size()], random() % 100 == 0 ? 0 : stamp);
      if (i % 10 == 0) {
        left_.publish(bad.raw());
        right_.publish(bad.compressed());
      }
    }
  }

  /// Expects that both recognizers answer a new image and that no answer so far was invalid.
  void expectAnswers() {
    static double stamp = 2e9;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      const Answers& answers = *answers_[i];
      stamp += 100;
      EXPECT_TRUE(eventually([&] {
        send(drawRoom(1, 1), stamp);
        ros::WallDuration(0.1).sleep();
        return answers.newest() == stamp;
      })) << kNames[i];
      EXPECT_EQ(answers.unsound(), 0) << kNames[i];
    }
  }

  ros::NodeHandle node_;
  ros::Publisher left_ = node_.advertise<sensor_msgs::Image>("/left_camera/image", 2);
  ros::Publisher right_ =
      node_.advertise<sensor_msgs::CompressedImage>("/right_camera/image/compressed", 2);
  std::vector<std::unique_ptr<Answers>> answers_ = [this] {
    std::vector<std::unique_ptr<Answers>> all;
    for (const std::string& name : kNames) all.push_back(std::make_unique<Answers>(node_, name));
    return all;
  }();
};

TEST_F(Stress, OrdersFromAllSidesAtOnce) {
  std::atomic<bool> over{false};
  std::vector<std::thread> threads;
  const auto repeat = [&](const std::function<void(const std::string&, int)>& order) {
    threads.emplace_back([&over, order] {
      for (int i = 0; !over; ++i) order(kNames[static_cast<std::size_t>(i % 2)], i / 2);
    });
  };
  repeat([](const std::string& name, int i) { load(name, i % 2 == 0 ? "two" : "three"); });
  repeat([](const std::string& name, int) { trigger(name, "reload_model"); });
  repeat([](const std::string& name, int) { load(name, "absent"); });
  repeat([](const std::string& name, int) { trigger(name, "reset"); });
  repeat([](const std::string& name, int i) {
    reconfigure(name, "unknown_threshold", i % 3 - 1);
    reconfigure(name, "smoothing", i % 2);
    reconfigure(name, "maximum_rate", i % 2 == 0 ? 0 : 30);
  });
  repeat([](const std::string& name, int i) {
    enable(name, i % 2 == 0);
    ros::WallDuration(0.05).sleep();
  });
  repeat([this](const std::string& name, int) {  // comes and goes
    const Inbox<sensor_msgs::Image> images(node_, "/" + name + "/debug_image");
    ros::WallDuration(0.1).sleep();
  });
  sendFor(rounds(5, 60));
  over = true;
  for (std::thread& thread : threads) thread.join();
  for (const std::string& name : kNames) {
    enable(name, true);
    reconfigure(name, "maximum_rate", 0);
  }
  expectAnswers();
}

TEST_F(Stress, LoadAndASubscriberThatNeverReads) {
  OtherProcess deaf({"/usr/bin/rostopic", "echo", "/left/debug_image"});
  ros::WallDuration(3).sleep();  // until the subscriber is connected
  deaf.pause();
  const int before = answers_[0]->count() + answers_[1]->count();
  sendFor(5);
  std::vector<std::size_t> memory;
  for (const std::string& name : kNames) memory.push_back(residentBytes("__name:=" + name));
  const int seconds = rounds(10, 600);
  sendFor(seconds);
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    EXPECT_GT(memory[i], 0u);
    EXPECT_LT(residentBytes("__name:=" + kNames[i]), memory[i] + (std::size_t{32} << 20))
        << kNames[i] << " grows";
  }
  EXPECT_GT(answers_[0]->count() + answers_[1]->count() - before, 20 * seconds);
  expectAnswers();
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  using namespace place_recognition;
  return runRostest(argc, argv, "stress_rostest", [] {
    saveRooms("two", 2);
    saveRooms("three", 3);
  });
}
