// Models that are loaded, replaced or missing while place_recognizer runs.

#include <place_recognition/ModelInfo.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "ros/recognizer_fixture.h"

namespace place_recognition {
namespace {

TEST_F(RecognizerNode, WithoutAModelSaysSoAndWaits) {
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

TEST_F(RecognizerNode, LoadsAnotherModelAndKeepsItIfTheNextIsBad) {
  Inbox<PlaceRecognition> answers(node_, name_ + "/recognition");
  Inbox<ModelInfo> infos(node_, name_ + "/model_info");
  EXPECT_NE(load("two").message.find("2 places"), std::string::npos);
  EXPECT_TRUE(infos.find([](const ModelInfo& info) {
    return info.name == "two" && info.places == std::vector<std::string>{"room0", "room1"} &&
           info.support_vectors > 0;
  }));
  std::ofstream(namedModelPath("foreign")) << "not a model";
  const std::string link = modelFolder() + "/link.places";
  std::filesystem::remove(link);
  std::filesystem::create_symlink(namedModelPath("three"), link);
  for (const std::string& bad :
       {std::string("foreign"), std::string("none"), std::string("../two"),
        std::string("/etc/passwd"), std::string("two.places"), std::string("link"), std::string(),
        std::string("two\0", 4), std::string(1 << 20, 'a')}) {
    const auto response = load(bad);
    EXPECT_FALSE(response.success) << bad.substr(0, 80);
    EXPECT_GT(response.message.size(), 20u);
  }
  const auto answer = answerTo(answers, drawRoom(1, 5));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->model_name, "two");
  const auto report = status("Model");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->level, diagnostic_msgs::DiagnosticStatus::WARN);
}

TEST_F(RecognizerNode, ReloadsTheFileThatWasReplaced) {
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

TEST_F(RecognizerNode, NeverMixesModels) {
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

}  // namespace
}  // namespace place_recognition
