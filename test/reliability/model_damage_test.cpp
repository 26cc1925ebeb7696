// Models of every preset, damaged at random or crafted: each is refused, or a sound model.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model.pb.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_run.h"
#include "recognition/model_container.h"
#include "reliability/allocation_meter.h"
#include "reliability/damage.h"
#include "reliability/preset_models.h"
#include "rounds.h"

namespace place_recognition {
namespace {

/// What reading a small file may take beside it: the parsed configuration and the entries.
constexpr std::size_t kConstant = 24 << 20;
/// The message, the features and their index take more memory than their bytes in a file.
constexpr std::size_t kHeldPerByte = 12;

/// Parses `bytes`, within bounds of memory; false if they are refused.
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

std::string payloadOf(const std::string& bytes) {
  return std::string(unpackContainer(bytes, "whole"));
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

TEST(ModelDamage, APayloadWithAFittingHeaderIsRefusedOrUsable) {
  std::vector<std::string> payloads;
  for (const std::string& bytes : presetModels()) payloads.push_back(payloadOf(bytes));
  Damage damage(payloads, 2);
  int accepted = 0;
  const int count = rounds(2000, 20000);
  for (int i = 0; i < count; ++i) {
    const std::string bytes = packContainer(damage.next());
    if (!accepts(bytes)) continue;
    ++accepted;
    if (accepted % 20 == 0) expectUsable(bytes);
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, count);
}

/// A crafted model: the message of the first preset, changed, with a fitting header.
std::string crafted(const std::function<void(proto::Model&)>& change) {
  proto::Model message;
  EXPECT_TRUE(message.ParseFromString(payloadOf(presetModels().front())));
  change(message);
  return packContainer(message.SerializeAsString());
}

constexpr int kMany = 1000000;

TEST(CraftedModel, ManyEmptyPlacesTakeNoMemory) {
  EXPECT_FALSE(accepts(crafted([](proto::Model& m) {
    for (int i = 0; i < kMany; ++i) m.add_places();
  })));
}

TEST(CraftedModel, ManyEmptyClassifiersTakeNoMemory) {
  EXPECT_FALSE(accepts(crafted([](proto::Model& m) {
    for (int i = 0; i < kMany; ++i) m.add_classifiers();
  })));
}

TEST(CraftedModel, ManyEmptyInputsTakeNoMemory) {
  EXPECT_FALSE(accepts(crafted([](proto::Model& m) {
    for (int i = 0; i < kMany; ++i) m.mutable_provenance()->add_inputs();
  })));
}

TEST(CraftedModel, ManyUnknownFieldsTakeNoMemory) {
  std::string payload = payloadOf(presetModels().front());
  for (int i = 0; i < kMany; ++i) payload += std::string("\xfa\x07\x00", 3);  // field 127, empty
  accepts(packContainer(payload));
}

TEST(CraftedModel, ConfigurationsThatRepeatThemselvesAreRefused) {
  std::string cue = "&c {name: a, feature: {type: crfh, descriptors: [";
  for (int i = 0; i < 10000; ++i) cue += "L,";
  std::string options = "cues: [" + cue + "L]}}";
  for (int i = 0; i < 8000; ++i) options += ",*c";
  EXPECT_FALSE(accepts(crafted([&](proto::Model& m) { m.set_options(options + "]"); })));
}

TEST(CraftedModel, DeepConfigurationsAreRefused) {
  std::string blocks;
  for (int i = 0; i < 30000; ++i) blocks += "- ";
  for (const std::string& deep : {std::string(60000, '['), std::string(60000, '{'), blocks}) {
    EXPECT_FALSE(accepts(crafted([&](proto::Model& m) { m.set_options(deep); })));
  }
}

}  // namespace
}  // namespace place_recognition
