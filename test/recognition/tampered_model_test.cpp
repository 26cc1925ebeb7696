// Damaged and altered model files, and the errors of their reader.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <string>

#include "error_of.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/fitting_header.h"
#include "recognition/model_contents.h"
#include "recognition/small_model.h"

namespace place_recognition {
namespace {

TEST(TamperedModelFile, RefusesEveryChangedByteAndEveryCut) {
  const std::string& bytes = smallModelBytes();
  std::mt19937 generator(4);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = bytes;
    // Every byte of the header, and random bytes after it.
    const std::size_t at = i < 32 ? static_cast<std::size_t>(i) : generator() % bytes.size();
    changed[at] = static_cast<char>(changed[at] ^ (1 << generator() % 8));
    EXPECT_THROW(parseModel(changed, "changed"), Error) << at;
    const std::size_t length = i < 40 ? static_cast<std::size_t>(i) : generator() % bytes.size();
    EXPECT_THROW(parseModel(bytes.substr(0, length), "cut"), Error) << length;
  }
  EXPECT_THROW(parseModel(bytes + '\0', "longer"), Error);
  EXPECT_THROW(parseModel("", "empty"), Error);
}

TEST(TamperedModelFile, RefusesOtherFormats) {
  std::string bytes = smallModelBytes();
  --bytes[8];
  const std::string error = errorOf([&] { parseModel(bytes, "old"); });
  EXPECT_NE(error.find("its format version is 2"), std::string::npos) << error;
}

TEST(TamperedModelFile, RefusesSplicedFiles) {
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

TEST(TamperedModelFile, OfHugeWeightsGivesNoAnswerThatIsNotFinite) {
  const auto model = std::make_shared<const Model>(
      parseModel(tampered(smallModelBytes(),
                          [](ModelContents& contents) {
                            for (ClassifierNumbers& numbers : contents.classifiers) {
                              for (double& weight : numbers.weights) {
                                weight = weight < 0 ? -1.7e308 : 1.7e308;
                              }
                            }
                          }),
                 "huge"));
  Recognizer recognizer(model);
  const Recognition& answer = recognizer.recognize(drawRoom(0, 1));
  EXPECT_EQ(answer.place, -1);
  EXPECT_FALSE(answer.known);
  EXPECT_TRUE(answer.probabilities.allFinite());
}

struct Tampering {
  const char* name;
  std::function<void(ModelContents&)> change;
};

class TamperedModel : public testing::TestWithParam<Tampering> {};

TEST_P(TamperedModel, IsRefusedByName) {
  const std::string bytes = tampered(smallModelBytes(), GetParam().change);
  const std::string error = errorOf([&] { parseModel(bytes, "kitchen.places"); });
  EXPECT_NE(error.find("kitchen.places"), std::string::npos) << error;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kFloatNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

// The model that is tampered with; its second cue has common and rare bins.
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
        Tampering{"LimitNan", [](auto& c) { message(c).set_decision_limit(kNan); }},
        Tampering{"LimitNegative", [](auto& c) { message(c).set_decision_limit(-1); }},
        Tampering{"SlopeNan", [](auto& c) { message(c).set_calibration_slope(kNan); }},
        Tampering{"SlopeNegative", [](auto& c) { message(c).set_calibration_slope(-1); }},
        Tampering{"WeightOfEvidenceHuge",
                  [](auto& c) { message(c).set_evidence_weights(0, 1e308); }},
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
                  [](auto& c) { message(c).mutable_provenance()->clear_place_images(); }},
        Tampering{"HashesOfNoRun",
                  [](auto& c) { message(c).mutable_provenance()->clear_image_hash_counts(); }},
        Tampering{"HashesCut",
                  [](auto& c) { message(c).mutable_provenance()->clear_image_hashes(); }},
        Tampering{"HashesOfARunThatIsNotNamed",
                  [](auto& c) { message(c).mutable_provenance()->add_image_hash_counts(0); }},
        Tampering{"HashesDescend",
                  [](auto& c) { message(c).mutable_provenance()->set_image_hashes(1, 0); }}),
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

TEST(TamperedModelFile, RefusesRandomContentsWithAFittingHeader) {
  std::mt19937 generator(6);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string changed = smallModelBytes();
    changed[generator() % changed.size()] = static_cast<char>(generator());
    try {
      // A file that passes must still be a model: checked, usable, and the same when written back.
      serializeModel(parseModel(withFittingHeader(changed), "random"));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace place_recognition
