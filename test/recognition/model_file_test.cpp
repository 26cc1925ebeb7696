#include "place_recognition/model_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>

#include "base/atomic_file.h"
#include "learning/classifier_parts.h"
#include "place_recognition/error.h"
#include "recognition/drawn_recording.h"
#include "recognition/model_contents.h"
#include "recognition/small_model.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

TEST(ModelFile, KeepsEveryDecisionValue) {
  const Model& model = smallModel();
  const Model read = parseModel(smallModelBytes(), "test");
  ASSERT_EQ(read.classifiers.size(), model.classifiers.size());
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    for (const Feature& feature : ClassifierParts::of(model.classifiers[c]).support_set.vectors()) {
      Eigen::VectorXd scratch;
      Eigen::RowVectorXd decision_values, read_values;
      model.classifiers[c].decisionValues(feature, scratch, decision_values);
      read.classifiers[c].decisionValues(feature, scratch, read_values);
      EXPECT_EQ(decision_values, read_values);
    }
  }
}

TEST(ModelFile, KeepsEverythingElse) {
  const Model& model = smallModel();
  const Model read = parseModel(smallModelBytes(), "test");
  EXPECT_EQ(serializeModel(read), smallModelBytes());
  EXPECT_EQ(read.places, (std::vector<std::string>{"room0", "room1", "room2"}));
  EXPECT_EQ(read.cue_weights, model.cue_weights);
  EXPECT_EQ(read.decision_limit, 2);
  EXPECT_EQ(read.calibration.slope, model.calibration.slope);
  EXPECT_EQ(read.unknown_threshold, model.unknown_threshold);
  EXPECT_EQ(read.validation.average_rate, model.validation.average_rate);
  EXPECT_EQ(read.validation.calibration_error, model.validation.calibration_error);
  EXPECT_EQ(read.options.cues[1].kernel.gamma, model.options.cues[1].kernel.gamma);
  EXPECT_EQ(read.provenance.inputs, std::vector<std::string>{"drawn"});
  EXPECT_EQ(read.provenance.place_images, (std::vector<std::uint64_t>{12, 12, 12}));
  EXPECT_EQ(read.provenance.sketches, model.provenance.sketches);
  ASSERT_EQ(read.provenance.sketches.size(), 1u);
  EXPECT_EQ(read.provenance.sketches[0].hashes().size(), 36u);
}

TEST(ModelFile, KeepsWhatTheImagesWereLike) {
  const ImageProfile& images = smallModel().images;
  const ImageProfile read = parseModel(smallModelBytes(), "test").images;
  EXPECT_EQ(read.width, 96);
  EXPECT_EQ(read.height, 72);
  EXPECT_EQ(read.colour, images.colour);
  EXPECT_EQ(read.darkest, images.darkest);
  EXPECT_EQ(read.brightest, images.brightest);
  EXPECT_FALSE(read.levels.known());
  Model infrared = parseModel(smallModelBytes(), "test");
  infrared.images.levels = {10, 900};
  const LevelRange levels = parseModel(serializeModel(infrared), "test").images.levels;
  EXPECT_EQ(levels.low, 10u);
  EXPECT_EQ(levels.high, 900u);

  const auto changed = [](const std::function<void(proto::Model&)>& change) {
    return parseModel(
        tampered(smallModelBytes(), [&](ModelContents& contents) { change(contents.message); }),
        "test");
  };
  EXPECT_FALSE(changed([](proto::Model& model) { model.clear_images(); }).images.known());
  EXPECT_THROW(changed([](proto::Model& model) { model.mutable_images()->set_width(0); }), Error);
  EXPECT_THROW(changed([](proto::Model& model) { model.mutable_images()->set_height(1 << 20); }),
               Error);
  EXPECT_THROW(changed([](proto::Model& model) { model.mutable_images()->set_darkest(NAN); }),
               Error);
  EXPECT_THROW(changed([](proto::Model& model) { model.mutable_images()->set_depth_low(70); }),
               Error);
  EXPECT_THROW(changed([](proto::Model& model) { model.mutable_images()->set_depth_high(65536); }),
               Error);
  EXPECT_THROW(changed([](proto::Model& model) { model.mutable_images()->set_brightest(256); }),
               Error);
}

TEST(ModelFile, KeepsTheFramesThatJudgedIt) {
  const HeldOutFrames& frames = smallModel().held_out;
  const HeldOutFrames read = parseModel(smallModelBytes(), "test").held_out;
  EXPECT_EQ(frames.places.size(), 36u);
  EXPECT_EQ(read.places, frames.places);
  EXPECT_EQ(read.folds, frames.folds);
  EXPECT_EQ(read.decision_values, frames.decision_values);
  EXPECT_EQ(read.familiarity, frames.familiarity);
}

TEST(ModelFile, KeepsWhatWasAskedForApartFromWhatWasFound) {
  const Model read = parseModel(smallModelBytes(), "test");
  EXPECT_EQ(read.asked.reduction.method, "auto");
  EXPECT_EQ(read.asked.validation.gap, 0);
  EXPECT_EQ(read.asked.cues[0].kernel.gamma, 0);
  EXPECT_NE(read.options.reduction.method, "auto");
  EXPECT_GT(read.options.validation.gap, 0);
  EXPECT_GT(read.options.cues[0].kernel.gamma, 0);
}

TEST(ModelFile, ReadsFilesOfEarlierVersions) {
  const std::string earlier = tampered(smallModelBytes(), [](ModelContents& contents) {
    contents.message.clear_asked();
    contents.message.clear_held_out_frames();
    contents.message.clear_held_out_values();
    contents.message.set_options("validation: {folds: 4, gap: 2}\n" + [&] {
      std::string options = contents.message.options();
      const std::size_t begin = options.find("validation:");
      const std::size_t end = options.find("unknown:");
      return options.erase(begin, end - begin);
    }());
  });
  const Model read = parseModel(earlier, "test");
  EXPECT_EQ(read.asked.validation.folds, 4);
  EXPECT_EQ(read.asked.validation.gap, 0);  // it was a number of frames
  EXPECT_TRUE(read.validatedPlaces().empty());
  EXPECT_NO_THROW(trainIncrementally(read, {opener(drawFrames(3, 6, 700))}, {0}));
}

TEST(ModelFile, KeepsWhichRoomsAdjoin) {
  Model model = parseModel(smallModelBytes(), "test");
  model.adjacency.join(2, 0);
  model.adjacency.join(2, 1);
  const Model read = parseModel(serializeModel(model), "test");
  ASSERT_EQ(read.adjacency.places(), 3u);
  EXPECT_TRUE(read.adjacency.joined(0, 2));
  EXPECT_TRUE(read.adjacency.joined(1, 2));
  EXPECT_FALSE(read.adjacency.joined(0, 1));
  EXPECT_TRUE(parseModel(smallModelBytes(), "test").adjacency.empty());
}

TEST(ModelFile, IsSavedAndLoadedByPath) {
  const ScratchFolder folder;
  const std::string path = folder / "deep/er/house.places";
  EXPECT_EQ(saveModel(smallModel(), path), smallModelBytes().size());
  const Model model = loadModel(path);
  EXPECT_EQ(model.name, "house");
  EXPECT_EQ(model.version.size(), 8u);
  EXPECT_EQ(model.version, parseModel(smallModelBytes(), "test").version);
  EXPECT_THROW(loadModel(folder / "other.places"), Error);
}

TEST(ModelFile, ReplacesNoGoodModelByOneThatCannotBeLoaded) {
  const ScratchFolder folder;
  const std::string path = folder / "house.places";
  saveModel(smallModel(), path);
  Model broken = trainSmall().model;
  broken.calibration.slope = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(saveModel(broken, path), Error);
  EXPECT_EQ(loadModel(path).calibration.slope, smallModel().calibration.slope);
}

TEST(ModelFile, KeepsTheLastThree) {
  const ScratchFolder folder;
  const std::string path = folder / "house.places";
  for (const char* old : {"first", "second", "third", "fourth"}) {
    folder.write("house.places", old);
    saveModel(smallModel(), path);
  }
  EXPECT_EQ(readFile(path, 1 << 30), smallModelBytes());
  EXPECT_EQ(readFile(path + ".1", 100), "fourth");
  EXPECT_EQ(readFile(path + ".2", 100), "third");
  EXPECT_EQ(readFile(path + ".3", 100), "second");
  EXPECT_FALSE(std::filesystem::exists(path + ".4"));
}

TEST(ModelPath, IsANameOrAFile) {
  const ScratchFolder folder;
  setenv("ROS_HOME", (folder / "").c_str(), 1);
  const std::string root = folder / "/place_recognition/models";
  EXPECT_EQ(modelFolder(), root);
  EXPECT_EQ(modelPath("house_2-b"), root + "/house_2-b.places");
  EXPECT_EQ(modelPath("./house"), "./house");
  EXPECT_EQ(modelPath("file:///data/house"), "/data/house");
  EXPECT_EQ(modelPath("house.places"), "house.places");
  for (const std::string& name : {std::string(), std::string("a b"), std::string("a\0/b", 4),
                                  std::string("a.b"), std::string(65, 'a'), std::string("..")}) {
    EXPECT_THROW(modelPath(name), Error) << name;
  }
  for (const char* name : {"/etc/passwd", "../house", "a/b", "house.places"}) {
    EXPECT_THROW(namedModelPath(name), Error) << name;
  }
  unsetenv("ROS_HOME");
}

TEST(ModelPath, SaysWhereAFileBelongs) {
  setenv("ROS_HOME", "/ros", 1);
  try {
    namedModelPath("elsewhere/rooms.places");
    ADD_FAILURE();
  } catch (const Error& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find("; copy the file to /ros/place_recognition/models/rooms.places and give "
                           "the name rooms."),
              std::string::npos)
        << message;
  }
  unsetenv("ROS_HOME");
}

TEST(ModelPath, DoesNotFollowLinks) {
  const ScratchFolder folder;
  setenv("ROS_HOME", (folder / "").c_str(), 1);
  std::filesystem::create_directories(modelFolder());
  std::filesystem::create_symlink(folder.write("secret", "x"), modelFolder() + "/link.places");
  EXPECT_THROW(namedModelPath("link"), Error);
  unsetenv("ROS_HOME");
}

}  // namespace
}  // namespace place_recognition
