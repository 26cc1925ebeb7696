// Models of every preset, randomly damaged or crafted: each is refused or is a sound model.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/fitting_header.h"
#include "recognition/model_contents.h"
#include "reliability/allocation_meter.h"
#include "reliability/damage.h"
#include "reliability/preset_models.h"
#include "rounds.h"

namespace place_recognition {
namespace {

/// Memory that reading a small file may need beyond it: the parsed configuration and the entries.
constexpr std::size_t kConstant = 24 << 20;
/// The message, the features and their index take more memory than their bytes in a file.
constexpr std::size_t kHeldPerByte = 12;

/// Parses `bytes` and expects bounded memory. Returns false if they are refused.
bool accepts(const std::string& bytes) {
  const AllocationMeter meter;
  bool accepted = true;
  try {
    parseModel(bytes, "damaged");
  } catch (const Error&) {
    accepted = false;
  }
  EXPECT_LE(meter.largest(), 2 * bytes.size() + kConstant);
  EXPECT_LE(meter.peak(), kHeldPerByte * bytes.size() + kConstant);
  return accepted;
}

void expectUsable(const std::string& bytes) {
  const auto model = std::make_shared<const Model>(parseModel(bytes, "accepted"));
  Recognizer recognizer(model);
  const Recognition& answer = recognizer.recognize(drawRoom(1, 3));
  for (Eigen::Index place = 0; place < answer.probabilities.size(); ++place) {
    EXPECT_TRUE(std::isfinite(answer.probabilities[place]));
  }
}

TEST(ModelDamage, EveryPresetIsTrained) {
  EXPECT_GE(presetModels().size(), 6u);
  for (const std::string& bytes : presetModels()) {
    EXPECT_TRUE(accepts(bytes));
    expectUsable(bytes);
  }
}

TEST(ModelDamage, NoChangeOfAFilePasses) {
  const std::vector<std::string>& models = presetModels();
  Damage damage(models, 1);
  for (int i = 0, count = rounds(2000, 20000); i < count; ++i) {
    const std::string bytes = damage.next();
    const bool unchanged = std::find(models.begin(), models.end(), bytes) != models.end();
    EXPECT_EQ(accepts(bytes), unchanged);
  }
}

TEST(ModelDamage, ContentsWithAFittingHeaderAreRefusedOrUsable) {
  Damage damage(presetModels(), 2);
  int accepted = 0;
  const int count = rounds(2000, 20000);
  for (int i = 0; i < count; ++i) {
    const std::string bytes = withFittingHeader(damage.next());
    if (!accepts(bytes)) continue;
    ++accepted;
    if (accepted % 20 == 0) expectUsable(bytes);
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, count);
}

/// A crafted model: the contents of the first preset's, changed, with a fitting header.
std::string crafted(const std::function<void(ModelContents&)>& change) {
  return tampered(presetModels().front(), change);
}

constexpr int kMany = 1000000;

TEST(CraftedModel, ManyEmptyPlacesTakeNoMemory) {
  EXPECT_FALSE(
      accepts(crafted([](ModelContents& c) { c.message.mutable_places()->append(kMany, '\0'); })));
}

TEST(CraftedModel, ManyEmptyInputsTakeNoMemory) {
  EXPECT_FALSE(accepts(crafted([](ModelContents& c) {
    c.message.mutable_provenance()->mutable_inputs()->append(kMany, '\0');
  })));
}

TEST(CraftedModel, ManyUnknownFieldsTakeNoMemory) {
  std::string fields;
  for (int i = 0; i < kMany; ++i) fields += std::string("\xfa\x07\x00", 3);  // field 127, empty
  accepts(crafted([&](ModelContents& c) { c.message.MergeFromString(fields); }));
}

TEST(CraftedModel, ManyBinsOfNoVectorTakeNoMemory) {
  EXPECT_FALSE(accepts(crafted([](ModelContents& c) {
    PostingLists& lists = c.classifiers[0].lists;
    for (int i = 0; i < kMany; ++i) lists.bins.push_back(lists.bins.back() + 1);
    lists.counts.resize(lists.bins.size(), 0);
  })));
}

TEST(CraftedModel, ArraysLongerThanTheFileTakeNoMemory) {
  // The count of the first array, at the end of the message.
  const std::string& model = presetModels().front();
  std::uint32_t message_size = 0;
  std::memcpy(&message_size, &model[12], sizeof(message_size));
  for (const int byte : {3, 5, 7}) {
    std::string bytes = model;
    bytes[32 + message_size + byte] = '\x7f';
    EXPECT_FALSE(accepts(withFittingHeader(bytes)));
  }
}

TEST(CraftedModel, ConfigurationsThatRepeatThemselvesAreRefused) {
  std::string cue = "&c {name: a, feature: {type: crfh, descriptors: [";
  for (int i = 0; i < 10000; ++i) cue += "L,";
  std::string options = "cues: [" + cue + "L]}}";
  for (int i = 0; i < 8000; ++i) options += ",*c";
  EXPECT_FALSE(accepts(crafted([&](ModelContents& c) { c.message.set_options(options + "]"); })));
}

TEST(CraftedModel, DeepConfigurationsAreRefused) {
  std::string blocks;
  for (int i = 0; i < 30000; ++i) blocks += "- ";
  for (const std::string& deep : {std::string(60000, '['), std::string(60000, '{'), blocks}) {
    EXPECT_FALSE(accepts(crafted([&](ModelContents& c) { c.message.set_options(deep); })));
  }
}

}  // namespace
}  // namespace place_recognition
