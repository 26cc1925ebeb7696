// What a goal from the network can and cannot make place_tool do.

#include "ros/trainer/train_command.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "error_of.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

class TrainCommand : public testing::Test {
 protected:
  TrainCommand() {
    scratch_.write("run.bag", "");
    // A stand-in: the command is not run here.
    const std::string tool = scratch_.write("place_tool", "");
    std::filesystem::permissions(tool, std::filesystem::perms::owner_all);
    setenv("PLACE_RECOGNITION_LIBEXEC", (scratch_ / "").c_str(), 1);
    goal_.bags = {"run.bag"};
    goal_.model = "home";
  }

  std::vector<std::string> command() { return trainCommand(goal_, {scratch_ / ""}, "/tmp/c.yaml"); }

  std::string errorAfter(const std::function<void(TrainGoal&)>& change) {
    TrainGoal goal = goal_;
    change(goal);
    return errorOf([&] { trainCommand(goal, {scratch_ / ""}, "/tmp/c.yaml"); });
  }

  bool has(const std::string& argument) {
    const std::vector<std::string> arguments = command();
    return std::count(arguments.begin(), arguments.end(), argument) == 1;
  }

  ScratchFolder scratch_;
  TrainGoal goal_;
};

TEST_F(TrainCommand, OfASmallGoal) {
  const std::vector<std::string> expected = {scratch_ / "place_tool", "train",
                                             scratch_ / "run.bag",    "--model=home",
                                             "--progress=json",       "--json=-"};
  std::vector<std::string> arguments = command();
  arguments[0] = std::filesystem::canonical(arguments[0]).string();
  EXPECT_EQ(arguments, expected);
}

TEST_F(TrainCommand, OfEveryField) {
  goal_.preset = "crfh_colour";
  goal_.reduction = "shared-qr";
  goal_.image_topic = "/camera/image_raw";
  goal_.label_topic = "/label";
  EXPECT_TRUE(has("--config=crfh_colour"));
  EXPECT_TRUE(has("--set=reduction.method=shared-qr"));
  EXPECT_TRUE(has("--image-topic=/camera/image_raw"));
  EXPECT_TRUE(has("--label-topic=/label"));
  goal_.label_topic.clear();
  goal_.label = "--help";
  EXPECT_TRUE(has("--label=--help"));
  goal_.label = "0";  // a room's name, not an unset number
  EXPECT_TRUE(has("--label=0"));
  goal_.preset.clear();
  goal_.yaml = "seed: 2";
  EXPECT_TRUE(has("--config=/tmp/c.yaml"));
}

TEST_F(TrainCommand, ToLearnOn) {
  goal_.add_to = "monday";
  goal_.vector_limit = 300;
  goal_.threads = 1;
  EXPECT_TRUE(has("--add-to=monday"));
  EXPECT_TRUE(has("--limit=300"));
  EXPECT_TRUE(has("--threads=1"));
  goal_.forgetting = 0.25;
  goal_.from_model = "tuesday";
  goal_.bags.clear();
  EXPECT_TRUE(has("--forgetting=0.25"));
  EXPECT_TRUE(has("--from-model=tuesday"));
}

TEST_F(TrainCommand, ToCalibrate) {
  goal_.calibrate = true;
  goal_.threads = 2;
  const std::vector<std::string> arguments = command();
  EXPECT_EQ(arguments[1], "calibrate");
  EXPECT_TRUE(has("--model=home"));
  EXPECT_TRUE(has("--threads=2"));
  EXPECT_FALSE(has("--calibrate=1"));
}

TEST(InTermsOfGoal, NamesFieldsInsteadOfOptions) {
  EXPECT_EQ(inTermsOfGoal("place_tool train: --validate: a.bag is also learned; give another run."),
            "validate: a.bag is also learned; give another run.");
  EXPECT_EQ(inTermsOfGoal("place_tool: --from-model and --add-to, --label or --label-topic"),
            "from_model and add_to, label or label_topic");
  EXPECT_EQ(inTermsOfGoal("--limit"), "vector_limit");
  EXPECT_EQ(inTermsOfGoal("rosbag record --repeat-latched; place_tool label a.bag: --"),
            "rosbag record --repeat-latched; place_tool label a.bag: --");
}

TEST_F(TrainCommand, BadFieldsAreNamed) {
  const auto expectNamed = [this](const std::string& field,
                                  const std::function<void(TrainGoal&)>& change) {
    EXPECT_NE(errorAfter(change).find(field), std::string::npos) << errorAfter(change);
  };
  expectNamed("bags", [](TrainGoal& g) { g.bags.clear(); });
  expectNamed("bags", [](TrainGoal& g) { g.bags.resize(1001, "run.bag"); });
  expectNamed("run2.bag", [](TrainGoal& g) { g.bags.push_back("run2.bag"); });
  for (const char* name : {"", "../x", "a/b", "a.places", "a b", "\xff"}) {
    expectNamed("model", [name](TrainGoal& g) { g.model = name; });
  }
  expectNamed("model", [](TrainGoal& g) { g.model = std::string("a\0b", 3); });
  expectNamed("model", [](TrainGoal& g) { g.model = std::string(65, 'a'); });
  expectNamed("preset", [](TrainGoal& g) { g.preset = "../secret.yaml"; });
  expectNamed("preset", [](TrainGoal& g) { g.preset = "crfh", g.yaml = "seed: 1"; });
  expectNamed("yaml", [](TrainGoal& g) { g.yaml = std::string(1 << 20, ' '); });
  expectNamed("reduction", [](TrainGoal& g) { g.reduction = "qr --out=/etc/passwd"; });
  expectNamed("add_to", [](TrainGoal& g) { g.add_to = "../monday"; });
  expectNamed("add_to", [](TrainGoal& g) { g.add_to = "monday", g.preset = "crfh"; });
  expectNamed("vector_limit", [](TrainGoal& g) { g.vector_limit = 10; });
  expectNamed("vector_limit", [](TrainGoal& g) { g.add_to = "a", g.vector_limit = 2000000; });
  expectNamed("from_model", [](TrainGoal& g) { g.from_model = "a"; });
  expectNamed("from_model", [](TrainGoal& g) { g.add_to = "a", g.from_model = "../b"; });
  expectNamed("forgetting", [](TrainGoal& g) { g.add_to = "a", g.forgetting = 0.5; });
  expectNamed("forgetting", [](TrainGoal& g) {
    g.add_to = "a", g.vector_limit = 10, g.forgetting = std::nan("");
  });
  expectNamed("calibrate", [](TrainGoal& g) { g.calibrate = true, g.preset = "crfh"; });
  expectNamed("calibrate", [](TrainGoal& g) { g.calibrate = true, g.add_to = "home"; });
  expectNamed("threads", [](TrainGoal& g) { g.threads = 100000; });
  expectNamed("image_topic", [](TrainGoal& g) { g.image_topic = "a topic"; });
  expectNamed("image_topic", [](TrainGoal& g) { g.image_topic = "/front,a topic"; });
  expectNamed("label_topic", [](TrainGoal& g) { g.label_topic = std::string(1000, 'a'); });
  expectNamed("label", [](TrainGoal& g) { g.label = "a\nb"; });
  expectNamed("label_topic", [](TrainGoal& g) { g.label = "a", g.label_topic = "/b"; });
  expectNamed("recognizers", [](TrainGoal& g) { g.recognizers = {""}; });
  expectNamed("recognizers", [](TrainGoal& g) { g.recognizers = {"not a name"}; });
  expectNamed("recognizers", [](TrainGoal& g) { g.recognizers.resize(101, "/a"); });
}

}  // namespace
}  // namespace place_recognition
