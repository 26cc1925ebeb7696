// place_recognizer as others see it: images in, answers out; models, switches and diagnostics.
// See recognizer.test for the nodes.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <place_recognition/LoadModel.h>
#include <place_recognition/ModelInfo.h>
#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>

#include "place_recognition/model_file.h"
#include "recognition/drawn_run.h"
#include "ros/conversions.h"
#include "ros/inbox.h"

namespace place_recognition {
namespace {

void saveRooms(const std::string& name, int rooms, std::uint64_t seed = 1) {
  TrainingOptions options = quickOptions();
  options.seed = seed;
  saveModel(train({opener(drawFrames(rooms, 20))}, options).model, namedModelPath(name));
}

std_msgs::Header headerAt(double stamp) {
  std_msgs::Header header;
  header.stamp = ros::Time(stamp);
  header.frame_id = "camera_optical";
  return header;
}

/// A camera that sends raw and compressed images to whoever listens.
class Camera {
 public:
  explicit Camera(ros::NodeHandle& node)
      : raw_(node.advertise<sensor_msgs::Image>("/camera/image", 1)),
        compressed_(node.advertise<sensor_msgs::CompressedImage>("/camera/image/compressed", 1)) {}

  void send(const cv::Mat& image, double stamp) {
    raw_.publish(toImageMessage(image, headerAt(stamp)));
    sensor_msgs::CompressedImage message;
    message.header = headerAt(stamp);
    message.format = "png";
    cv::imencode(".png", image, message.data);
    compressed_.publish(message);
  }
  void send(const sensor_msgs::Image& message) { raw_.publish(message); }

  std::uint32_t rawListeners() const { return raw_.getNumSubscribers(); }
  std::uint32_t compressedListeners() const { return compressed_.getNumSubscribers(); }

 private:
  ros::Publisher raw_;
  ros::Publisher compressed_;
};

class Recognizer : public testing::Test {
 protected:
  explicit Recognizer(const std::string& name = "/recognizer") : name_(name) {}

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

  /// Sends a picture until its answer has come; nothing if none comes.
  std::optional<PlaceRecognition> answerTo(Inbox<PlaceRecognition>& answers, const cv::Mat& image) {
    if (!eventually([this] { return listeners() > 0; })) return std::nullopt;
    const ros::Time stamp = nextStamp();
    camera_.send(image, stamp.toSec());
    return answers.find([stamp](const auto& answer) { return answer.header.stamp == stamp; });
  }

  /// The last report named "NODE: WHAT"; nothing if none comes.
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

  /// That the node takes images as long as there is a subscriber to `topic`, and no longer.
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

class EveryTransport : public Recognizer, public testing::WithParamInterface<std::string> {
 protected:
  EveryTransport() : Recognizer(GetParam()) {}
};

TEST_P(EveryTransport, AnswersWithTheHeaderOfTheImage) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  for (int room = 0; room < 3; ++room) {
    const auto answer = answerTo(answers, drawRoom(room, 77));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->header.frame_id, "camera_optical");
    EXPECT_EQ(answer->place, "room" + std::to_string(room));
    EXPECT_EQ(answer->model_name, "three");
    EXPECT_EQ(answer->model_version.size(), 8u);
    ASSERT_EQ(answer->places.size(), 3u);
    double sum = 0;
    double largest = 0;
    for (const PlaceScore& score : answer->places) {
      EXPECT_TRUE(std::isfinite(score.margin));
      sum += score.probability;
      largest = std::max(largest, score.probability);
    }
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_EQ(answer->confidence, largest);
    EXPECT_GT(answer->seconds, 0);
  }
  ros::WallDuration(0.3).sleep();
  EXPECT_EQ(answers.messages().size(), 3u);  // one an image, never repeated
}

INSTANTIATE_TEST_SUITE_P(All, EveryTransport,
                         testing::Values("/recognizer", "/compressed_recognizer",
                                         "/nodelet_recognizer"));

TEST_F(Recognizer, WithoutAModelSaysSoAndWaits) {
  name_ = "/empty_recognizer";
  EXPECT_TRUE(ros::service::waitForService(name_ + "/load_model", 15000));
  const auto report = status("Model");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->level, diagnostic_msgs::DiagnosticStatus::ERROR);
  EXPECT_NE(report->message.find("no model"), std::string::npos);
  const auto response = trigger("reload_model");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("absent"), std::string::npos) << response.message;
}

TEST_F(Recognizer, LoadsAnotherModelAndKeepsItIfTheNextIsBad) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  Inbox<ModelInfo> infos(node_, name_ + "/model_info");
  EXPECT_NE(load("two").message.find("2 places"), std::string::npos);
  EXPECT_TRUE(infos.find([](const ModelInfo& info) {
    return info.name == "two" && info.places == std::vector<std::string>{"room0", "room1"} &&
           info.support_vectors > 0;
  }));
  std::ofstream(namedModelPath("foreign")) << "not a model";
  for (const char* bad : {"foreign", "none", "../two", "/etc/passwd", "two.places"}) {
    const auto response = load(bad);
    EXPECT_FALSE(response.success) << bad;
    EXPECT_GT(response.message.size(), 20u);
  }
  const auto answer = answerTo(answers, drawRoom(1, 5));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->model_name, "two");
  const auto report = status("Model");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->level, diagnostic_msgs::DiagnosticStatus::WARN);
}

TEST_F(Recognizer, ReloadsTheFileThatWasReplaced) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  const auto before = answerTo(answers, drawRoom(0, 1));
  saveRooms("three", 3, 2);
  EXPECT_TRUE(trigger("reload_model").success);
  const auto after = answerTo(answers, drawRoom(0, 1));
  saveRooms("three", 3);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->model_name, "three");
  EXPECT_NE(after->model_version, before->model_version);
}

TEST_F(Recognizer, NeverMixesModels) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(0, 1)));
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(load(i % 2 == 0 ? "two" : "three").success);
    for (unsigned k = 0; k < 5; ++k) {
      camera_.send(drawRoom(1, k), nextStamp().toSec());
      ros::WallDuration(0.01).sleep();
    }
  }
  std::set<std::string> models;
  for (const PlaceRecognition& answer : answers.messages()) {
    models.insert(answer.model_name);
    EXPECT_EQ(answer.places.size(), answer.model_name == "two" ? 2u : 3u);
  }
  EXPECT_EQ(models.size(), 2u);
}

TEST_F(Recognizer, UnusableImagesAreReportedAndSurvived) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(0, 1)));
  sensor_msgs::Image bad = toImageMessage(drawRoom(0, 1), headerAt(nextStamp().toSec()));
  bad.height = 65537;
  camera_.send(bad);
  ros::WallDuration(0.2).sleep();
  bad = toImageMessage(drawRoom(0, 1), headerAt(nextStamp().toSec()));
  bad.encoding = "32FC1";
  camera_.send(bad);
  ros::WallDuration(0.2).sleep();
  ASSERT_TRUE(answerTo(answers, drawRoom(2, 1)));
  EXPECT_EQ(answers.messages().size(), 2u);
  const auto report = status("Images");
  ASSERT_TRUE(report);
  EXPECT_GE(std::stoi(valueOf(*report, "unusable")), 2);
  EXPECT_NE(valueOf(*report, "last problem").find("32FC1"), std::string::npos);
}

TEST_F(Recognizer, ListensOnlyWhileSomebodyListensToIt) {
  EXPECT_TRUE(eventually([this] { return listeners() == 0; }));
  expectListensWith<PlaceRecognition>("/recognition");
  expectListensWith<std_msgs::String>("/place");
  expectListensWith<sensor_msgs::Image>("/debug_image");
}

TEST_F(Recognizer, NamesThePlaceLatchedAndOnceAChange) {
  Inbox<std_msgs::String> places(node_, name_ + "/place");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  ASSERT_TRUE(trigger("reset").success);
  // The answer is the one over time: a single frame of another room changes nothing.
  double stamp = nextStamp().toSec();
  for (const int room : {1, 1, 1, 1, 0, 1, 1, 1, 2, 2, 2, 2, 2}) {
    camera_.send(drawRoom(room, 3), stamp);
    stamp += 0.1;
    ros::WallDuration(0.2).sleep();
  }
  for (int i = 0; i < 3; ++i) nextStamp();
  const auto named = [](const std::string& name) {
    return [name](const std_msgs::String& place) { return place.data == name; };
  };
  EXPECT_TRUE(places.find(named("room1")));
  EXPECT_TRUE(places.find(named("room2")));
  int first_room = 0, stray = 0;
  for (const std_msgs::String& place : places.messages()) {
    first_room += place.data == "room1";
    stray += place.data == "room0";
  }
  EXPECT_EQ(first_room, 1);
  EXPECT_EQ(stray, 0);
  Inbox<std_msgs::String> latecomer(node_, name_ + "/place");
  EXPECT_TRUE(latecomer.find(named("room2")));
  EXPECT_TRUE(trigger("reset").success);
  EXPECT_TRUE(latecomer.find(named("unknown")));
}

TEST_F(Recognizer, CanBeSwitchedOff) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  enable(false);
  EXPECT_TRUE(eventually([this] { return listeners() == 0; }));
  answers.clear();
  camera_.send(drawRoom(1, 2), nextStamp().toSec());
  ros::WallDuration(0.3).sleep();
  EXPECT_TRUE(answers.messages().empty());
  enable(true);
  EXPECT_TRUE(answerTo(answers, drawRoom(1, 3)));
}

TEST_F(Recognizer, DrawsItsAnswer) {
  Inbox<sensor_msgs::Image> pictures(node_, name_ + "/debug_image");
  ASSERT_TRUE(eventually([this] { return listeners() > 0; }));
  const ros::Time stamp = nextStamp();
  camera_.send(drawRoom(0, 1), stamp.toSec());
  const auto picture = pictures.find([](const sensor_msgs::Image&) { return true; });
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->header.stamp, stamp);
  EXPECT_EQ(picture->width, 96u);
  EXPECT_GT(picture->height, 72u);
}

TEST_F(Recognizer, TakesItsThresholdLive) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  reconfigure("unknown_threshold", 0);
  const auto sure = answerTo(answers, drawRoom(1, 1));
  reconfigure("unknown_threshold", 1);
  const auto unsure = answerTo(answers, drawRoom(1, 1));
  reconfigure("unknown_threshold", -1);
  ASSERT_TRUE(sure && unsure);
  EXPECT_TRUE(sure->known);
  EXPECT_FALSE(unsure->known);
  EXPECT_EQ(unsure->place, "room1");  // the best guess all the same
}

TEST_F(Recognizer, KeepsToItsRateAndStartsAnewWhenTimeJumpsBack) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  reconfigure("maximum_rate", 2);
  const double start = nextStamp().toSec() + 10;
  answers.clear();
  const auto play = [&] {
    for (int i = 0; i < 30; ++i) {  // three seconds of ten images, played faster
      camera_.send(drawRoom(1, 1), start + 0.1 * i);
      ros::WallDuration(0.05).sleep();
    }
  };
  play();
  play();  // a looped bag
  reconfigure("maximum_rate", 0);
  EXPECT_TRUE(eventually([&] { return answers.messages().size() >= 12; }, 1));
  EXPECT_NEAR(static_cast<double>(answers.messages().size()), 12, 3);
  EXPECT_TRUE(trigger("reset").success);
}

TEST_F(Recognizer, CountsWhatItSkipsWhileBusy) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  ASSERT_TRUE(answerTo(answers, drawRoom(1, 1)));
  cv::Mat large;
  cv::resize(drawRoom(1, 1), large, cv::Size(1920, 1440));
  ros::Time last;
  for (int i = 0; i < 100; ++i) {
    last = nextStamp();
    camera_.send(toImageMessage(large, headerAt(last.toSec())));
    ros::WallDuration(0.005).sleep();
  }
  // The newest is among those answered.
  EXPECT_TRUE(answers.find([last](const auto& answer) { return answer.header.stamp == last; }));
  const auto report = status("Images");
  ASSERT_TRUE(report);
  EXPECT_NE(valueOf(*report, "skipped while busy"), "missing");
  EXPECT_NE(valueOf(*report, "answers"), "missing");
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "recognizer_rostest");
  ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  place_recognition::saveRooms("two", 2);
  place_recognition::saveRooms("three", 3);
  return RUN_ALL_TESTS();
}
