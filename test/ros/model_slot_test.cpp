// Replacing the model in use.

#include "ros/recognizer/model_slot.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "error_of.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

class ModelSlots : public testing::Test {
 protected:
  ModelSlots() {
    setenv("ROS_HOME", (scratch_ / "ros").c_str(), 1);
    save("two", 2);
    save("three", 3);
  }

  void save(const std::string& name, int rooms) {
    saveModel(train({opener(drawFrames(rooms, 8))}, quickOptions()).model, namedModelPath(name));
  }

  std::string errorOfLoading(const std::string& name) {
    return errorOf([&] { slot_.load(name); });
  }

  ScratchFolder scratch_;
  ModelSlot slot_;
};

TEST_F(ModelSlots, HoldNothingAtFirst) {
  EXPECT_EQ(slot_.model(), nullptr);
  EXPECT_THROW(slot_.reload(), Error);
}

TEST_F(ModelSlots, ExchangeTheModel) {
  slot_.load("two");
  const std::shared_ptr<const Model> two = slot_.model();
  EXPECT_EQ(two->name, "two");
  slot_.load("three");
  EXPECT_EQ(slot_.model()->places.size(), 3u);
  EXPECT_EQ(two->places.size(), 2u);  // users of the old model keep it
}

TEST_F(ModelSlots, KeepTheModelIfItsFileIsUnchanged) {
  slot_.load("two");
  const std::shared_ptr<const Model> two = slot_.model();
  slot_.reload();
  EXPECT_EQ(slot_.model(), two);
  save("two", 3);
  slot_.reload();
  EXPECT_NE(slot_.model(), two);
}

TEST_F(ModelSlots, NameACopyOfTheModelByItsOwnName) {
  save("copy", 2);
  slot_.load("two");
  slot_.load("copy");
  EXPECT_EQ(slot_.model()->name, "copy");
}

TEST_F(ModelSlots, KeepTheModelIfTheNextIsBad) {
  slot_.load("two");
  const std::shared_ptr<const Model> two = slot_.model();
  std::filesystem::copy_file(namedModelPath("three"), namedModelPath("cut"));
  std::filesystem::resize_file(namedModelPath("cut"), 1000);
  for (const char* name : {"cut", "none", "../two", "", "two.places"}) {
    const std::string error = errorOfLoading(name);
    EXPECT_NE(error, "") << name;
    EXPECT_EQ(slot_.problem(), error);
    EXPECT_EQ(slot_.model(), two);
  }
  slot_.reload();
  EXPECT_EQ(slot_.model()->name, "two");
  EXPECT_EQ(slot_.problem(), "");
}

TEST_F(ModelSlots, ReloadWhatWasMissingAtFirst) {
  EXPECT_NE(errorOfLoading("later"), "");
  save("later", 2);
  slot_.reload();
  EXPECT_EQ(slot_.model()->name, "later");
}

TEST_F(ModelSlots, AreNotConfusedByManyAtOnce) {
  slot_.load("two");
  std::atomic<bool> done{false};
  std::vector<std::thread> loaders;
  for (const char* name : {"two", "three", "none"}) {
    loaders.emplace_back([this, name, &done] {
      while (!done) errorOfLoading(name);
    });
  }
  // The file is replaced while it is being read.
  for (int i = 0; i < 20; ++i) save("three", 3);
  for (int i = 0; i < 2000; ++i) {
    const std::shared_ptr<const Model> model = slot_.model();
    ASSERT_EQ(model->places.size(), model->name == "two" ? 2u : 3u);
  }
  done = true;
  for (std::thread& loader : loaders) loader.join();
}

}  // namespace
}  // namespace place_recognition
