#include "base/yaml_guard.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

std::string errorOf(const std::string& text) {
  try {
    requireModestYaml(text, "a.yaml");
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(YamlGuard, LetsConfigurationsPass) {
  EXPECT_EQ(errorOf("cues:\n  - name: a\n    feature: {type: crfh, scales: [1, 4]}\nseed: 1\n"),
            "");
  EXPECT_EQ(errorOf(""), "");
  EXPECT_EQ(errorOf("a: '*b'"), "");
  std::string many = "[";
  for (int i = 0; i < 1000; ++i) many += "[],";
  EXPECT_EQ(errorOf(many + "]"), "");
}

TEST(YamlGuard, RefusesDepthBeforeGoingThere) {
  std::string blocks;
  for (int i = 0; i < 100000; ++i) blocks += "- ";
  for (const std::string& deep : {std::string(100000, '['), std::string(100000, '{'), blocks}) {
    EXPECT_NE(errorOf(deep).find("a.yaml is nested too deeply"), std::string::npos);
  }
}

TEST(YamlGuard, RefusesRepetition) {
  EXPECT_NE(errorOf("a: &x [1, 2]\nb: *x\n").find("a.yaml has an alias ('*') in line 2"),
            std::string::npos);
}

TEST(YamlGuard, LeavesOtherFaultsToTheParser) {
  EXPECT_THROW(requireModestYaml("{[", "a.yaml"), YAML::Exception);
}

}  // namespace
}  // namespace place_recognition
