#include "place_recognition/model_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <random>

#include "base/atomic_file.h"
#include "learning/machines.h"
#include "learning/support_set.h"
#include "model.pb.h"
#include "place_recognition/error.h"
#include "recognition/drawn_run.h"
#include "recognition/model_container.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

Training trainSmall() { return train({opener(drawFrames(3, 12))}, twoCueOptions(), 1); }

const Model& smallModel() {
  static const Training training = trainSmall();
  return training.model;
}

const std::string& smallModelBytes() {
  static const std::string bytes = serializeModel(smallModel());
  return bytes;
}

TEST(ModelFile, KeepsEveryMargin) {
  const Model& model = smallModel();
  const Model read = parseModel(smallModelBytes(), "test");
  ASSERT_EQ(read.classifiers.size(), model.classifiers.size());
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    for (const Feature& feature : model.classifiers[c].supportSet().vectors()) {
      Eigen::VectorXd scratch;
      Eigen::RowVectorXd margins, read_margins;
      model.classifiers[c].margins(feature, scratch, margins);
      read.classifiers[c].margins(feature, scratch, read_margins);
      EXPECT_EQ(margins, read_margins);
    }
  }
}

TEST(ModelFile, KeepsEverythingElse) {
  const Model& model = smallModel();
  const Model read = parseModel(smallModelBytes(), "test");
  EXPECT_EQ(serializeModel(read), smallModelBytes());
  EXPECT_EQ(read.places, (std::vector<std::string>{"room0", "room1", "room2"}));
  EXPECT_EQ(read.cue_weights, model.cue_weights);
  EXPECT_EQ(read.calibration.slope, model.calibration.slope);
  EXPECT_EQ(read.unknown_threshold, model.unknown_threshold);
  EXPECT_EQ(read.validation.average_rate, model.validation.average_rate);
  EXPECT_EQ(read.validation.calibration_error, model.validation.calibration_error);
  EXPECT_EQ(read.options.cues[1].kernel.gamma, model.options.cues[1].kernel.gamma);
  EXPECT_EQ(read.provenance.inputs, std::vector<std::string>{"drawn"});
  EXPECT_EQ(read.provenance.place_images, (std::vector<std::uint64_t>{12, 12, 12}));
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

TEST(ModelFile, RefusesEveryChangedByteAndEveryCut) {
  const std::string& bytes = smallModelBytes();
  std::mt19937 generator(4);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = bytes;
    // Every byte of the header, and random ones behind it.
    const std::size_t at = i < 24 ? static_cast<std::size_t>(i) : generator() % bytes.size();
    changed[at] = static_cast<char>(changed[at] ^ (1 << generator() % 8));
    EXPECT_THROW(parseModel(changed, "changed"), Error) << at;
    const std::size_t length = i < 40 ? static_cast<std::size_t>(i) : generator() % bytes.size();
    EXPECT_THROW(parseModel(bytes.substr(0, length), "cut"), Error) << length;
  }
  EXPECT_THROW(parseModel(bytes + '\0', "longer"), Error);
  EXPECT_THROW(parseModel("", "empty"), Error);
}

TEST(ModelFile, RefusesSplicedFiles) {
  const std::string& bytes = smallModelBytes();
  std::mt19937 generator(5);
  for (int i = 0; i < 500; ++i) {
    const std::size_t from = generator() % bytes.size(), to = generator() % bytes.size();
    const std::size_t length = 1 + generator() % 200;
    std::string spliced = bytes;
    spliced.replace(to, length, bytes, from, length);
    if (spliced == bytes) continue;
    EXPECT_THROW(parseModel(spliced, "spliced"), Error);
  }
}

/// The message inside a model's bytes, changed by `change`, with a fitting header.
std::string tampered(const std::function<void(proto::Model&)>& change) {
  const std::string_view payload = unpackContainer(smallModelBytes(), "test");
  proto::Model message;
  EXPECT_TRUE(message.ParseFromArray(payload.data(), static_cast<int>(payload.size())));
  change(message);
  return packContainer(message.SerializeAsString());
}

struct Tampering {
  const char* name;
  std::function<void(proto::Model&)> change;
};

class TamperedModel : public testing::TestWithParam<Tampering> {};

TEST_P(TamperedModel, IsRefusedByName) {
  try {
    parseModel(tampered(GetParam().change), "kitchen.places");
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("kitchen.places"), std::string::npos) << e.what();
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
proto::Vectors& vectors(proto::Model& m) {
  return *m.mutable_classifiers(0)->mutable_support_vectors();
}

INSTANTIATE_TEST_SUITE_P(
    ModelFile, TamperedModel,
    testing::Values(
        Tampering{"NoOptions", [](auto& m) { m.set_options("cues: []"); }},
        Tampering{"UnknownOption", [](auto& m) { m.set_options("colour: red"); }},
        Tampering{"OptionsThatAreNoYaml", [](auto& m) { m.set_options("{["); }},
        Tampering{"HugeOptions", [](auto& m) { m.set_options(std::string(1 << 20, '[')); }},
        Tampering{"OptionOutOfRange", [](auto& m) { m.set_options("svm: {c: -1}"); }},
        Tampering{"OnePlace", [](auto& m) { m.mutable_places()->Clear(), m.add_places("a"); }},
        Tampering{"PlaceTwice", [](auto& m) { m.set_places(1, m.places(0)); }},
        Tampering{"PlaceOfControlCharacters", [](auto& m) { m.set_places(0, "a\nb"); }},
        Tampering{"PlaceAdded", [](auto& m) { m.add_places("room9"); }},
        Tampering{"ClassifierMissing", [](auto& m) { m.mutable_classifiers()->RemoveLast(); }},
        Tampering{"WeightsOfCuesMissing", [](auto& m) { m.clear_cue_weights(); }},
        Tampering{"WeightOfCueNan", [](auto& m) { m.set_cue_weights(0, kNan); }},
        Tampering{"WeightsOfCuesZero",
                  [](auto& m) { m.set_cue_weights(0, 0), m.set_cue_weights(1, 0); }},
        Tampering{"WeightMissing",
                  [](auto& m) { m.mutable_classifiers(0)->mutable_weights()->RemoveLast(); }},
        Tampering{"WeightNan", [](auto& m) { m.mutable_classifiers(0)->set_weights(0, kNan); }},
        Tampering{"BiasNan", [](auto& m) { m.mutable_classifiers(0)->set_biases(0, kNan); }},
        Tampering{"BiasMissing",
                  [](auto& m) { m.mutable_classifiers(0)->mutable_biases()->RemoveLast(); }},
        Tampering{"KindOfVectors", [](auto& m) { vectors(m).set_kind(proto::Vectors::DENSE); }},
        Tampering{"KindThatDoesNotExist",
                  [](auto& m) { vectors(m).set_kind(static_cast<proto::Vectors::Kind>(7)); }},
        Tampering{"SizeHuge", [](auto& m) { vectors(m).set_sizes(0, 0xffffffffu); }},
        Tampering{"ValueMissing", [](auto& m) { vectors(m).mutable_values()->RemoveLast(); }},
        Tampering{"ValueNan", [](auto& m) { vectors(m).set_values(0, static_cast<float>(kNan)); }},
        Tampering{"ValueZero", [](auto& m) { vectors(m).set_values(0, 0); }},
        Tampering{"IndexMissing", [](auto& m) { vectors(m).mutable_index_steps()->pop_back(); }},
        Tampering{"IndexAdded", [](auto& m) { vectors(m).mutable_index_steps()->push_back(1); }},
        Tampering{"IndexRepeated", [](auto& m) { (*vectors(m).mutable_index_steps())[4] = 0; }},
        Tampering{"IndexTooLarge",
                  [](auto& m) { vectors(m).set_index_steps(std::string(5000, '\xff')); }},
        Tampering{"SlopeNan", [](auto& m) { m.set_calibration_slope(kNan); }},
        Tampering{"SlopeNegative", [](auto& m) { m.set_calibration_slope(-1); }},
        Tampering{"ThresholdNan", [](auto& m) { m.set_unknown_threshold(kNan); }},
        Tampering{"ValidationOutOfRange", [](auto& m) { m.set_validation_average_rate(1.5); }},
        Tampering{"HalfAPairOfRooms", [](auto& m) { m.add_adjacency(0); }},
        Tampering{"PairOfOneRoom", [](auto& m) { m.add_adjacency(1), m.add_adjacency(1); }},
        Tampering{"PairWithNoRoom", [](auto& m) { m.add_adjacency(0), m.add_adjacency(3); }},
        Tampering{"PairTwice",
                  [](auto& m) {
                    for (const unsigned place : {0u, 1u, 0u, 1u}) m.add_adjacency(place);
                  }},
        Tampering{"CountsMissing", [](auto& m) { m.mutable_provenance()->clear_place_images(); }}),
    [](const auto& info) { return info.param.name; });

TEST(ModelFile, RefusesRandomPayloadsWithAFittingHeader) {
  const std::string_view payload = unpackContainer(smallModelBytes(), "test");
  std::mt19937 generator(6);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string changed(payload);
    changed[generator() % changed.size()] = static_cast<char>(generator());
    try {
      // What passes is a model all the same: checked, usable, and written back.
      serializeModel(parseModel(packContainer(changed), "random"));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(ModelFile, IsSavedAndLoadedByPath) {
  const ScratchFolder folder;
  const std::string path = folder / "deep/er/house.places";
  EXPECT_EQ(saveModel(smallModel(), path), smallModelBytes().size());
  const Model model = loadModel(path);
  EXPECT_EQ(model.name, "house");
  EXPECT_EQ(model.version.size(), 8u);
  EXPECT_EQ(model.version, containerVersion(smallModelBytes()));
  EXPECT_THROW(loadModel(folder / "other.places"), Error);
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
