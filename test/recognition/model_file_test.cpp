#include "place_recognition/model_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <random>

#include "base/atomic_file.h"
#include "learning/classifier_parts.h"
#include "place_recognition/error.h"
#include "recognition/drawn_recording.h"
#include "recognition/fitting_header.h"
#include "recognition/model_contents.h"
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
  EXPECT_EQ(read.calibration.slope, model.calibration.slope);
  EXPECT_EQ(read.unknown_threshold, model.unknown_threshold);
  EXPECT_EQ(read.validation.average_rate, model.validation.average_rate);
  EXPECT_EQ(read.validation.calibration_error, model.validation.calibration_error);
  EXPECT_EQ(read.options.cues[1].kernel.gamma, model.options.cues[1].kernel.gamma);
  EXPECT_EQ(read.provenance.inputs, std::vector<std::string>{"drawn"});
  EXPECT_EQ(read.provenance.place_images, (std::vector<std::uint64_t>{12, 12, 12}));
}

TEST(ModelFile, KeepsWhatTheImagesWereLike) {
  const ImageProfile& images = smallModel().images;
  const ImageProfile read = parseModel(smallModelBytes(), "test").images;
  EXPECT_EQ(read.width, 96);
  EXPECT_EQ(read.height, 72);
  EXPECT_EQ(read.colour, images.colour);
  EXPECT_EQ(read.darkest, images.darkest);
  EXPECT_EQ(read.brightest, images.brightest);
  EXPECT_FALSE(read.depth.known());
  Model infrared = parseModel(smallModelBytes(), "test");
  infrared.images.depth = {10, 900};
  const DepthExtent depth = parseModel(serializeModel(infrared), "test").images.depth;
  EXPECT_EQ(depth.low, 10u);
  EXPECT_EQ(depth.high, 900u);

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

TEST(ModelFile, RefusesEveryChangedByteAndEveryCut) {
  const std::string& bytes = smallModelBytes();
  std::mt19937 generator(4);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = bytes;
    // Every byte of the header, and random ones behind it.
    const std::size_t at = i < 32 ? static_cast<std::size_t>(i) : generator() % bytes.size();
    changed[at] = static_cast<char>(changed[at] ^ (1 << generator() % 8));
    EXPECT_THROW(parseModel(changed, "changed"), Error) << at;
    const std::size_t length = i < 40 ? static_cast<std::size_t>(i) : generator() % bytes.size();
    EXPECT_THROW(parseModel(bytes.substr(0, length), "cut"), Error) << length;
  }
  EXPECT_THROW(parseModel(bytes + '\0', "longer"), Error);
  EXPECT_THROW(parseModel("", "empty"), Error);
}

TEST(ModelFile, RefusesOtherFormats) {
  std::string bytes = smallModelBytes();
  --bytes[8];
  try {
    parseModel(bytes, "old");
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("its format version is 2"), std::string::npos) << e.what();
  }
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

struct Tampering {
  const char* name;
  std::function<void(ModelContents&)> change;
};

class TamperedModel : public testing::TestWithParam<Tampering> {};

TEST_P(TamperedModel, IsRefusedByName) {
  try {
    parseModel(tampered(smallModelBytes(), GetParam().change), "kitchen.places");
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("kitchen.places"), std::string::npos) << e.what();
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kFloatNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

// What is tampered with; the second cue has common and rare bins.
proto::Model& message(ModelContents& c) { return c.message; }
ClassifierNumbers& classifier(ModelContents& c) { return c.classifiers[1]; }
PostingLists& lists(ModelContents& c) { return c.classifiers[1].lists; }

INSTANTIATE_TEST_SUITE_P(
    Message, TamperedModel,
    testing::Values(
        Tampering{"NoOptions", [](auto& c) { message(c).set_options("cues: []"); }},
        Tampering{"UnknownOption", [](auto& c) { message(c).set_options("colour: red"); }},
        Tampering{"OptionsThatAreNoYaml", [](auto& c) { message(c).set_options("{["); }},
        Tampering{"HugeOptions",
                  [](auto& c) { message(c).set_options(std::string(1 << 20, '[')); }},
        Tampering{"OptionOutOfRange", [](auto& c) { message(c).set_options("svm: {c: -1}"); }},
        Tampering{"OnePlace", [](auto& c) { message(c).set_places("a", 2); }},
        Tampering{"PlaceTwice", [](auto& c) { message(c).set_places("a\0a\0b", 6); }},
        Tampering{"PlaceOfControlCharacters",
                  [](auto& c) { message(c).set_places("a\nb\0c\0d", 8); }},
        Tampering{"PlaceAdded", [](auto& c) { message(c).mutable_places()->append("s", 2); }},
        Tampering{"PlaceWithoutEnd", [](auto& c) { message(c).mutable_places()->pop_back(); }},
        Tampering{"WeightsOfCuesMissing", [](auto& c) { message(c).clear_cue_weights(); }},
        Tampering{"WeightOfCueNan", [](auto& c) { message(c).set_cue_weights(0, kNan); }},
        Tampering{
            "WeightsOfCuesZero",
            [](auto& c) { message(c).set_cue_weights(0, 0), message(c).set_cue_weights(1, 0); }},
        Tampering{"SlopeNan", [](auto& c) { message(c).set_calibration_slope(kNan); }},
        Tampering{"SlopeNegative", [](auto& c) { message(c).set_calibration_slope(-1); }},
        Tampering{"ThresholdNan", [](auto& c) { message(c).set_unknown_threshold(kNan); }},
        Tampering{"ValidationOutOfRange",
                  [](auto& c) { message(c).set_validation_average_rate(1.5); }},
        Tampering{"HalfAPairOfRooms", [](auto& c) { message(c).add_adjacency(0); }},
        Tampering{"PairOfOneRoom",
                  [](auto& c) { message(c).add_adjacency(1), message(c).add_adjacency(1); }},
        Tampering{"PairWithNoRoom",
                  [](auto& c) { message(c).add_adjacency(0), message(c).add_adjacency(3); }},
        Tampering{"PairTwice",
                  [](auto& c) {
                    for (const unsigned place : {0u, 1u, 0u, 1u}) message(c).add_adjacency(place);
                  }},
        Tampering{"HalfAHeldOutFrame", [](auto& c) { message(c).add_held_out_frames(0); }},
        Tampering{"HeldOutFrameOfNoPlace", [](auto& c) { message(c).set_held_out_frames(0, 3); }},
        Tampering{"HeldOutFrameOfNoFold",
                  [](auto& c) { message(c).set_held_out_frames(1, 10000); }},
        Tampering{"HeldOutMarginMissing",
                  [](auto& c) { message(c).mutable_held_out_values()->RemoveLast(); }},
        Tampering{"HeldOutMarginNan",
                  [](auto& c) { message(c).set_held_out_values(1, std::nanf("")); }},
        Tampering{"CameraWithoutEnd", [](auto& c) { message(c).set_cameras("/front"); }},
        Tampering{"CamerasWithoutCorrelation", [](auto& c) { message(c).set_cameras("a\0b", 4); }},
        Tampering{"MoreCamerasThanARobotHas",
                  [](auto& c) {
                    message(c).set_cameras(std::string(18, '\0'));
                    for (int i = 0; i < 153; ++i) message(c).add_camera_correlations(0);
                  }},
        Tampering{"CorrelationAboveOne",
                  [](auto& c) {
                    message(c).set_cameras("a\0b", 4);
                    message(c).add_camera_correlations(1.5);
                  }},
        Tampering{"CorrelationNan",
                  [](auto& c) {
                    message(c).set_cameras("a\0b", 4);
                    message(c).add_camera_correlations(kNan);
                  }},
        Tampering{"CountsMissing",
                  [](auto& c) { message(c).mutable_provenance()->clear_place_images(); }}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Numbers, TamperedModel,
    testing::Values(
        Tampering{"ClassifierMissing", [](auto& c) { c.classifiers.pop_back(); }},
        Tampering{"ClassifierAdded", [](auto& c) { c.classifiers.push_back(classifier(c)); }},
        Tampering{"WeightMissing", [](auto& c) { classifier(c).weights.pop_back(); }},
        Tampering{"WeightNan", [](auto& c) { classifier(c).weights[0] = kNan; }},
        Tampering{"VectorWithoutWeight",
                  [](auto& c) { std::fill_n(classifier(c).weights.begin(), 3, 0); }},
        Tampering{"BiasNan", [](auto& c) { classifier(c).biases[0] = kNan; }},
        Tampering{"BiasMissing", [](auto& c) { classifier(c).biases.pop_back(); }},
        Tampering{"VectorOfNoPlace", [](auto& c) { classifier(c).vector_origins[0] = 3; }},
        Tampering{"VectorWithoutPlace", [](auto& c) { classifier(c).vector_origins.pop_back(); }},
        Tampering{"SetsOfDescriptorsToo", [](auto& c) { classifier(c).set_sizes = {0}; }},
        Tampering{"DescriptorsToo", [](auto& c) { classifier(c).descriptors = {0}; }},
        Tampering{"TotalMissing", [](auto& c) { lists(c).totals.pop_back(); }},
        Tampering{"TotalAdded", [](auto& c) { lists(c).totals.push_back(1); }},
        Tampering{"TotalNan", [](auto& c) { lists(c).totals[0] = kNan; }},
        Tampering{"TotalInfinite", [](auto& c) { lists(c).totals[0] = kInfinity; }},
        Tampering{"TotalNegative", [](auto& c) { lists(c).totals[0] = -1; }},
        Tampering{"BinRepeated", [](auto& c) { lists(c).bins[1] = lists(c).bins[0]; }},
        Tampering{"BinsDescend", [](auto& c) { std::swap(lists(c).bins[0], lists(c).bins[1]); }},
        Tampering{"BinsCut", [](auto& c) { lists(c).bins.pop_back(); }},
        Tampering{"BinsAdded", [](auto& c) { lists(c).bins.push_back(~std::uint64_t{0}); }},
        Tampering{"BinOfNoVector", [](auto& c) { lists(c).counts[0] = 0; }},
        Tampering{"BinOfTooManyVectors", [](auto& c) { lists(c).counts[0] = 100; }},
        Tampering{"BinOfOtherVectors", [](auto& c) { lists(c).counts[0] -= 1; }},
        Tampering{"CountsOfBinsCut", [](auto& c) { lists(c).counts.pop_back(); }},
        Tampering{"RowCut", [](auto& c) { lists(c).rows.pop_back(); }},
        Tampering{"RowNan", [](auto& c) { lists(c).rows[0] = kFloatNan; }},
        Tampering{"RowInfinite", [](auto& c) { lists(c).rows[0] = kFloatInfinity; }},
        Tampering{"RowNegative", [](auto& c) { lists(c).rows[0] = -1; }},
        Tampering{"ValueMissing", [](auto& c) { lists(c).values.pop_back(); }},
        Tampering{"ValueNan", [](auto& c) { lists(c).values[0] = kFloatNan; }},
        Tampering{"ValueInfinite", [](auto& c) { lists(c).values[0] = kFloatInfinity; }},
        Tampering{"ValueZero", [](auto& c) { lists(c).values[0] = 0; }},
        Tampering{"ValueNegative", [](auto& c) { lists(c).values[0] = -1; }},
        Tampering{"PostingMissing", [](auto& c) { lists(c).numbers.pop_back(); }},
        Tampering{"PostingOfNoVector", [](auto& c) { lists(c).numbers.back() = 0xffff; }},
        Tampering{"PostingsOfOneVector",
                  [](auto& c) {
                    std::fill(lists(c).numbers.begin(), lists(c).numbers.end(), std::uint16_t{0});
                  }}),
    [](const auto& info) { return info.param.name; });

TEST(ModelFile, RefusesRandomContentsWithAFittingHeader) {
  std::mt19937 generator(6);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string changed = smallModelBytes();
    changed[generator() % changed.size()] = static_cast<char>(generator());
    try {
      // What passes is a model all the same: checked, usable, and written back.
      serializeModel(parseModel(withFittingHeader(changed), "random"));
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
