#include "tuning/candidates.h"

#include <gtest/gtest.h>

#include <set>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

TrainingOptions withoutCues() {
  TrainingOptions options;
  options.cues.clear();
  return options;
}

TEST(Candidates, AFamilyHoldsEveryScaleAndBinCountThatFitsTheSimplestFirst) {
  SearchSpace space;
  space.descriptors = {{"Lx", "Ly"}, {"R", "G", "B"}};
  space.scales = {{1, 4}, {2}};
  space.bins = {16, 8};
  space.max_dimensions = 4;
  const std::vector<Family> families = candidateFamilies(withoutCues(), space);
  ASSERT_EQ(families.size(), 2u);
  std::vector<std::string> names;
  for (const CueOptions& cue : families[0].cues) names.push_back(cue.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Lx-Ly_t2_b8", "Lx-Ly_t2_b16", "Lx-Ly_t1-4_b8",
                                             "Lx-Ly_t1-4_b16"}));
  EXPECT_EQ(families[1].cues.size(), 2u) << "six dimensions are too many";
}

TEST(Candidates, EveryCueOfTheDefaultSpaceHasANameOfItsOwnAndChecks) {
  TrainingOptions options = withoutCues();
  std::set<std::string> names;
  for (const Family& family : candidateFamilies(options, SearchSpace())) {
    for (const CueOptions& cue : family.cues) {
      EXPECT_TRUE(names.insert(cue.name).second) << cue.name;
      options.cues.push_back(cue);
    }
  }
  EXPECT_NO_THROW(options.check());
}

TEST(Candidates, CuesOfTheBaseStandBesideTheSpace) {
  SearchSpace space;
  space.descriptors = {{"L"}};
  TrainingOptions base = withoutCues();
  base.cues = {CueOptions()};
  const std::vector<Family> families = candidateFamilies(base, space);
  ASSERT_EQ(families.size(), 2u);
  EXPECT_EQ(families[1].cues[0].name, "crfh");
}

TEST(Candidates, NothingToTryIsAnError) {
  SearchSpace space;
  space.max_dimensions = 1;
  space.descriptors = {{"Lx", "Ly"}};
  EXPECT_THROW(candidateFamilies(withoutCues(), space), Error);
}

TEST(SearchSpace, ValuesOutOfRangeAreRefusedByName) {
  SearchSpace space;
  space.c = {1, -1};
  try {
    space.check();
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("'c'"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace place_recognition
