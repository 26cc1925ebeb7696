#include "base/options.h"

#include <gtest/gtest.h>

#include "error_of.h"

namespace place_recognition {
namespace {

struct Round {
  static constexpr const char* kType = "round";
  double radius = 1;
  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("radius", self.radius, "m", "size");
  }
};

struct Square {
  static constexpr const char* kType = "square";
  std::vector<int> sides = {1, 2};
  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("sides", self.sides, "m");
  }
};

struct Part {
  std::string name = "part";
  std::variant<Round, Square> shape;
  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("name", self.name, "");
    visitor("shape", self.shape, "");
  }
};

struct Whole {
  bool on = false;
  std::uint64_t seed = 7;
  std::vector<Part> parts = {Part()};
  template <typename Self, typename Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("on", self.on, "");
    visitor("seed", self.seed, "");
    visitor("parts", self.parts, "");
  }
};

Whole readWhole(const std::string& yaml) {
  Whole whole;
  readOptions(parseYaml(yaml, "test"), "", whole);
  return whole;
}

std::string errorIn(const std::string& yaml) {
  return errorOf([&] { readWhole(yaml); });
}

TEST(Options, KeepDefaultsForWhatIsNotNamed) {
  const Whole whole = readWhole("on: true");
  EXPECT_TRUE(whole.on);
  EXPECT_EQ(whole.seed, 7u);
  EXPECT_EQ(whole.parts.size(), 1u);
}

TEST(Options, AnEmptyFileChangesNothing) { EXPECT_EQ(readWhole("").seed, 7u); }

TEST(Options, AreOneDocument) {
  EXPECT_EQ(readWhole("---\nseed: 8\n---\n").seed, 8u);
  EXPECT_EQ(readWhole("seed: 8\n...\n").seed, 8u);
  EXPECT_THROW(readWhole("seed: 8\n---\nseed: 9\n"), Error);
}

TEST(Options, ReadNestedListsAndAlternatives) {
  const Whole whole =
      readWhole("parts: [{name: a, shape: {type: square, sides: 5}}, {shape: {radius: 0.25}}]");
  ASSERT_EQ(whole.parts.size(), 2u);
  EXPECT_EQ(std::get<Square>(whole.parts[0].shape).sides, std::vector<int>{5});
  EXPECT_EQ(std::get<Round>(whole.parts[1].shape).radius, 0.25);
}

TEST(Options, ReadBackWhatTheyWrite) {
  Whole whole = readWhole("{on: true, parts: [{shape: {type: square}}, {shape: {radius: 0.1}}]}");
  whole.parts[1].name = "true";  // text that could be read as another type
  const std::string text = writeOptions(whole);
  EXPECT_EQ(writeOptions(readWhole(text)), text);
  EXPECT_NE(text.find("radius: 0.1\n"), std::string::npos) << text;
}

TEST(Options, ReadFormerKeysAndWriteTheNewOnes) {
  const Whole whole = readWhole("parts: [{shape: {size: 0.25}}]");
  EXPECT_EQ(std::get<Round>(whole.parts[0].shape).radius, 0.25);
  const std::string text = writeOptions(whole);
  EXPECT_NE(text.find("radius: 0.25"), std::string::npos) << text;
  EXPECT_EQ(text.find("size"), std::string::npos) << text;
  EXPECT_EQ(errorIn("parts: [{shape: {size: wide}}]"),
            "Option 'parts[0].shape.size' is 'wide'; give a number.");
  EXPECT_EQ(errorIn("parts: [{shape: {radius: 1, size: 1}}]"),
            "Option 'size' in 'parts[0].shape' is now named 'radius'; give only that.");
}

TEST(Options, RefuseUnknownKeysAndListTheKnown) {
  EXPECT_EQ(errorIn("of: true"),
            "Unknown option 'of' in the configuration (did you mean on?); the known ones are: on, "
            "seed, parts.");
  EXPECT_EQ(errorIn("parts: [{shape: {radius: 1, sides: 2}}]"),
            "Unknown option 'sides' in 'parts[0].shape'; the known ones are: type, radius.");
}

TEST(Options, RefuseUnknownTypesWrongKindsAndRepetitions) {
  EXPECT_EQ(errorIn("parts: [{shape: {type: oval}}]"),
            "Unknown type 'oval' in 'parts[0].shape'; the known ones are: round, square.");
  EXPECT_EQ(errorIn("parts: [{shape: {type: squire}}]"),
            "Unknown type 'squire' in 'parts[0].shape' (did you mean square?); the known ones are: "
            "round, square.");
  EXPECT_EQ(errorIn("on: maybe"), "Option 'on' is 'maybe'; give true or false.");
  EXPECT_EQ(errorIn("seed: -1"), "Option 'seed' is '-1'; give a whole number from 0.");
  EXPECT_EQ(errorIn("seed: [1]"),
            "Option 'seed' is a list or mapping; give a whole number from 0.");
  EXPECT_EQ(errorIn("parts: [{shape: {radius: .nan}}]"),
            "Option 'parts[0].shape.radius' is not finite; give a finite number.");
  EXPECT_NE(errorIn("{on: true, on: false}"), "");
  EXPECT_NE(errorIn("[on]"), "");
  EXPECT_NE(errorIn("on: {"), "");
}

TEST(Options, RefuseEmptyElementsWhichWouldHideTheirDefaults) {
  EXPECT_EQ(errorIn("parts: {}"), "Option 'parts' is empty; give its keys, or leave it out.");
  EXPECT_EQ(errorIn("parts: [{}]"), "Option 'parts[0]' is empty; give its keys, or leave it out.");
  EXPECT_EQ(readWhole("parts: []").parts.size(), 0u);
}

TEST(Options, AssignByKeyNumberAndName) {
  const YAML::Node node = parseYaml(writeOptions(readWhole("parts: [{name: a}, {name: b}]")), "t");
  assignOption(node, "parts.0.shape.radius=3");
  assignOption(node, "parts.b.shape={type: square, sides: [4]}");
  assignOption(node, "on=true");
  Whole whole;
  readOptions(node, "", whole);
  EXPECT_EQ(std::get<Round>(whole.parts[0].shape).radius, 3);
  EXPECT_EQ(std::get<Square>(whole.parts[1].shape).sides, std::vector<int>{4});
  EXPECT_TRUE(whole.on);
}

TEST(Options, RefuseAssignmentsToNothing) {
  const YAML::Node node = parseYaml(writeOptions(Whole()), "test");
  EXPECT_THROW(assignOption(node, "on"), Error);
  EXPECT_THROW(assignOption(node, "=1"), Error);
  EXPECT_EQ(errorOf([&] { assignOption(node, "parts.7.name=x"); }),
            "'parts.7.name=x' sets no option: there is no '7' in 'parts'; the known ones are: "
            "part.");
  EXPECT_EQ(errorOf([&] { assignOption(node, "party.0.name=x"); }),
            "'party.0.name=x' sets no option: there is no 'party' (did you mean "
            "parts?); the known ones are: on, seed, parts.");
  EXPECT_EQ(errorOf([&] { assignOption(node, "on.deeper=x"); }),
            "'on.deeper=x' sets no option: there is no 'deeper' in 'on'; set on as a whole.");
  assignOption(node, "new=1");
  Whole whole;
  EXPECT_THROW(readOptions(node, "", whole), Error);
}

}  // namespace
}  // namespace place_recognition
