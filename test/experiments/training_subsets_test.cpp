#include "experiments/training_subsets.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

/// Forty images in one set: thirty of place 0, then ten of place 1.
SetSamples fortyImages() {
  SetSamples samples;
  samples.places.assign(30, 0);
  samples.places.insert(samples.places.end(), 10, 1);
  samples.sets.assign(40, 0);
  samples.place_count = 2;
  samples.set_count = 1;
  return samples;
}

TEST(SubsetOf, SpreadsOverAllOfARoomOrTakesNeighbours) {
  const SetSamples samples = fortyImages();
  const std::vector<int> train = samples.split(0).train;
  EXPECT_EQ(subsetOf(train, samples, 1, SubsetKind::kSpread), (std::vector<int>{15, 35}));
  EXPECT_EQ(subsetOf(train, samples, 3, SubsetKind::kSpread),
            (std::vector<int>{5, 15, 25, 31, 35, 38}));
  EXPECT_EQ(subsetOf(train, samples, 2, SubsetKind::kNeighbours),
            (std::vector<int>{14, 15, 34, 35}));
  for (const SubsetKind kind : {SubsetKind::kSpread, SubsetKind::kNeighbours}) {
    EXPECT_EQ(subsetOf(train, samples, 100, kind), train);
    EXPECT_EQ(subsetOf(train, samples, 20, kind).size(), 30u);  // all ten of place 1
  }
}

TEST(ViewpointsOf, AreTwelveSuccessiveImagesOfARoom) {
  const SetSamples samples = fortyImages();
  const std::vector<Viewpoint> viewpoints = viewpointsOf(samples.split(0).train, samples);
  ASSERT_EQ(viewpoints.size(), 4u);  // 12, 12 and 6 of place 0, 10 of place 1
  EXPECT_EQ(viewpoints[1].number, 2);
  EXPECT_EQ(viewpoints[1].samples.front(), 12);
  EXPECT_EQ(viewpoints[2].samples.size(), 6u);
  EXPECT_EQ(viewpoints[3].place, 1);
  EXPECT_EQ(viewpoints[3].number, 1);
  EXPECT_EQ(viewpoints[3].samples.size(), 10u);
}

}  // namespace
}  // namespace place_recognition
