#include "base/yaml_guard.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "error_of.h"

namespace place_recognition {
namespace {

std::string errorIn(const std::string& text) {
  return errorOf([&] { requireModestYaml(text, "a.yaml"); });
}

TEST(YamlGuard, LetsConfigurationsPass) {
  EXPECT_EQ(errorIn("cues:\n  - name: a\n    feature: {type: crfh, scales: [1, 4]}\nseed: 1\n"),
            "");
  EXPECT_EQ(errorIn(""), "");
  EXPECT_EQ(errorIn("a: '*b'"), "");
  std::string many = "[";
  for (int i = 0; i < 1000; ++i) many += "[],";
  EXPECT_EQ(errorIn(many + "]"), "");
}

TEST(YamlGuard, RefusesDepthBeforeGoingThere) {
  std::string blocks;
  for (int i = 0; i < 100000; ++i) blocks += "- ";
  for (const std::string& deep : {std::string(100000, '['), std::string(100000, '{'), blocks}) {
    EXPECT_NE(errorIn(deep).find("a.yaml is nested too deeply"), std::string::npos);
  }
}

TEST(YamlGuard, RefusesSignsInFrontOfWhichDocumentsHaveNoEnd) {
  EXPECT_NE(errorIn(",").find("unexpected sign in line 1, column 1"), std::string::npos);
  EXPECT_NE(errorIn("--- a\n---\n ,").find("unexpected sign in line 3, column 2"),
            std::string::npos);
  EXPECT_EQ(errorIn("---\n---\na: 1\n"), "");
}

TEST(YamlGuard, RefusesRepetition) {
  EXPECT_NE(errorIn("a: &x [1, 2]\nb: *x\n").find("a.yaml has an alias ('*') in line 2"),
            std::string::npos);
}

TEST(YamlGuard, LeavesOtherFaultsToTheParser) {
  EXPECT_THROW(requireModestYaml("{[", "a.yaml"), YAML::Exception);
}

}  // namespace
}  // namespace place_recognition
