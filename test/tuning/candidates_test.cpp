#include "tuning/candidates.h"

#include <gtest/gtest.h>

#include <set>

#include "error_of.h"

namespace place_recognition {
namespace {

TEST(Candidates, AFamilyHoldsEveryScaleAndBinCountThatFitsTheSimplestFirst) {
  SearchSpace space;
  space.descriptors = {{"Lx", "Ly"}, {"R", "G", "B"}};
  space.scales = {{1, 4}, {2}};
  space.bins = {16, 8};
  space.max_dimensions = 4;
  const std::vector<Family> families = candidateFamilies(space);
  ASSERT_EQ(families.size(), 2u);
  std::vector<std::string> names;
  for (const CueOptions& cue : families[0].cues) names.push_back(cue.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Lx-Ly_t2_b8", "Lx-Ly_t2_b16", "Lx-Ly_t1-4_b8",
                                             "Lx-Ly_t1-4_b16"}));
  EXPECT_EQ(families[1].cues.size(), 4u) << "run and grey-world; six dimensions are too many";
}

TEST(Candidates, EveryCueOfTheDefaultSpaceHasANameOfItsOwnAndChecks) {
  TrainingOptions options;
  options.cues.clear();
  std::set<std::string> names;
  for (const Family& family : candidateFamilies(SearchSpace())) {
    for (const CueOptions& cue : family.cues) {
      EXPECT_TRUE(names.insert(cue.name).second) << cue.name;
      options.cues.push_back(cue);
    }
  }
  EXPECT_NO_THROW(options.check());
}

TEST(Candidates, ColoursAreTriedInBothNormalizationsAndDerivativesAsRatios) {
  SearchSpace space;
  space.descriptors = {{"L", "C1"}, {"Lx", "Ly"}};
  space.scales = {{1}};
  space.bins = {8};
  const std::vector<Family> families = candidateFamilies(space);
  ASSERT_EQ(families[0].cues.size(), 2u);
  EXPECT_EQ(families[0].cues[0].normalize, "run");
  EXPECT_EQ(families[0].cues[1].normalize, "grey-world");
  ASSERT_EQ(families[1].cues.size(), 1u);
  EXPECT_EQ(std::get<CrfhOptions>(families[1].cues[0].feature).levels, "logarithmic");
}

TEST(Candidates, OfTooManyDimensionsAreNone) {
  SearchSpace space;
  space.max_dimensions = 1;
  space.descriptors = {{"Lx", "Ly"}};
  EXPECT_TRUE(candidateFamilies(space).empty());
}

TEST(SearchSpace, ValuesOutOfRangeAreRefusedByName) {
  SearchSpace space;
  space.c = {1, -1};
  const std::string error = errorOf([&] { space.check(); });
  EXPECT_EQ(error, "Option 'c' is -1; give numbers above 0, below 1e12.");
}

}  // namespace
}  // namespace place_recognition
