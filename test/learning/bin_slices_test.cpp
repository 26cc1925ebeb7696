#include "learning/bin_slices.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "learning/random_features.h"
#include "learning/support_set.h"

namespace place_recognition {
namespace {

/// Vectors of `size` elements each, of which about a tenth are in bins that others have, too.
std::vector<SparseVector> vectorsOf(std::size_t count, std::size_t size) {
  RandomFeatures random(8);
  std::vector<SparseVector> vectors(count);
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t i = 0; i < size; ++i) {
      vectors[v].indices.push_back(1000 * i + (i % 10 == 0 ? 0 : v));
      vectors[v].values.push_back(static_cast<float>(random.uniform(0.001, 1)));
    }
  }
  return vectors;
}

std::vector<const SparseVector*> pointersTo(const std::vector<SparseVector>& vectors) {
  std::vector<const SparseVector*> pointers;
  for (const SparseVector& vector : vectors) pointers.push_back(&vector);
  return pointers;
}

/// Expects every element once, and the bins of each slice above those of the last. Returns the
/// number of slices.
int expectEveryElement(const std::vector<SparseVector>& vectors) {
  std::map<std::pair<std::size_t, std::uint64_t>, float> seen;
  BinSlices slices(pointersTo(vectors));
  int count = 0;
  std::uint64_t first_allowed = 0;
  std::size_t elements = 0;
  for (; slices.next(); ++count) {
    std::uint64_t highest = 0;
    slices.forEach([&](std::size_t v, std::uint64_t bin, float value) {
      EXPECT_GE(bin, first_allowed);
      highest = std::max(highest, bin);
      EXPECT_TRUE(seen.emplace(std::make_pair(v, bin), value).second);
    });
    if (highest > 0) first_allowed = highest + 1;
  }
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    elements += vectors[v].size();
    for (std::size_t i = 0; i < vectors[v].size(); ++i) {
      const auto found = seen.find({v, vectors[v].indices[i]});
      EXPECT_TRUE(found != seen.end() && found->second == vectors[v].values[i]);
    }
  }
  EXPECT_EQ(seen.size(), elements);
  EXPECT_EQ(slices.elements(), elements);
  return count;
}

TEST(BinSlices, VisitEveryElementOnce) {
  EXPECT_GT(expectEveryElement(vectorsOf(300, 700)), 2);
  EXPECT_EQ(expectEveryElement(vectorsOf(3, 5)), 1);
  EXPECT_EQ(expectEveryElement({SparseVector(), SparseVector()}), 1);
  EXPECT_EQ(
      expectEveryElement({SparseVector{{0, std::numeric_limits<std::uint64_t>::max()}, {1, 2}}}),
      1);
}

TEST(BinSlices, CannotCutABinThatEveryVectorHas) {
  // As many elements as two slices hold, all in one bin.
  const std::vector<SparseVector> vectors(150000, SparseVector{{42}, {0.5f}});
  EXPECT_LE(expectEveryElement(vectors), 2);
}

TEST(BinSlices, SupportSetsOfManySlicesEqualThePlainKernel) {
  std::vector<Feature> features;
  for (SparseVector& vector : vectorsOf(200, 1000)) features.emplace_back(std::move(vector));
  const Kernel kernel(kernelOptions("chi-squared"));
  const SupportSet set(kernel, features);
  Eigen::VectorXd measures(set.size());
  for (const std::size_t x : {std::size_t{0}, std::size_t{77}, std::size_t{199}}) {
    set.measures(features[x], measures);
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double expected = kernel.measure(features[x], features[i]);
      EXPECT_NEAR(measures[static_cast<Eigen::Index>(i)], expected, 1e-9 * (1 + expected)) << i;
    }
  }
}

}  // namespace
}  // namespace place_recognition
