#include "learning/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "error_of.h"
#include "learning/random_features.h"

namespace place_recognition {
namespace {

/// x = (0.5, 0.5, 0, 0), y = (0.25, 0, 0.75, 0), sparse and dense.
struct Pair {
  Feature x;
  Feature y;
};
const Pair kSparse = {SparseVector{{0, 1}, {0.5f, 0.5f}}, SparseVector{{0, 2}, {0.25f, 0.75f}}};
const Pair kDense = {DenseVector{{0.5f, 0.5f, 0, 0}}, DenseVector{{0.25f, 0, 0.75f, 0}}};

struct Expectation {
  const char* type;
  double measure;
  double value;
};

/// Worked out by hand, with gamma = 2, p = 1, d = 3, kappa = 2, theta = 0.5.
const Expectation kExpectations[] = {
    {"linear", 0.125, 0.125},
    {"polynomial", 0.125, 1.423828125},
    {"sigmoid", 0.125, std::tanh(0.75)},
    {"gaussian", 0.875, std::exp(-1.75)},
    {"chi-squared", 4.0 / 3, std::exp(-8.0 / 3)},
    {"intersection", 0.25, 0.25},
};

KernelOptions optionsOf(const char* type) {
  KernelOptions options = kernelOptions(type, 2);
  options.kappa = 2;
  options.theta = 0.5;
  return options;
}

TEST(Kernel, EqualsTheFormulas) {
  for (const Expectation& expected : kExpectations) {
    const Kernel kernel(optionsOf(expected.type));
    for (const Pair& pair : {kSparse, kDense}) {
      EXPECT_NEAR(kernel.measure(pair.x, pair.y), expected.measure, 1e-15) << expected.type;
      EXPECT_NEAR(kernel(pair.x, pair.y), expected.value, 1e-15) << expected.type;
      EXPECT_EQ(kernel(pair.x, pair.y), kernel(pair.y, pair.x)) << expected.type;
    }
  }
}

TEST(Kernel, OfAVectorWithItself) {
  RandomFeatures random(1);
  const Feature x = random.histogram(300);
  EXPECT_EQ(Kernel(kernelOptions("gaussian"))(x, x), 1);
  EXPECT_EQ(Kernel(kernelOptions("chi-squared"))(x, x), 1);
  EXPECT_NEAR(Kernel(kernelOptions("intersection"))(x, x), 1, 1e-6);  // the sum of the histogram
  EXPECT_GT(Kernel(kernelOptions("linear"))(x, x), 0);
  const Feature set = random.descriptors(7);
  EXPECT_EQ(Kernel(kernelOptions("local-match"))(set, set), 1);
}

TEST(Kernel, TakesEmptyAndForeignBins) {
  const Feature empty = SparseVector{};
  const Feature low = SparseVector{{0}, {1}};
  const Feature high = SparseVector{{~std::uint64_t{0}}, {1}};
  const Kernel chi_squared(kernelOptions("chi-squared"));
  EXPECT_EQ(chi_squared.measure(empty, empty), 0);
  EXPECT_EQ(chi_squared.measure(empty, low), 1);
  EXPECT_EQ(chi_squared.measure(low, high), 2);
  EXPECT_EQ(chi_squared.measure(DenseVector{{0, 1}}, DenseVector{{0, 1}}), 0);
}

/// Returns a descriptor that is zero except for element 0.
void append(DescriptorSet& set, int element) {
  set.descriptors.resize(set.descriptors.size() + DescriptorSet::kDimension, 0);
  set.descriptors[set.descriptors.size() - DescriptorSet::kDimension] =
      static_cast<std::uint8_t>(element);
}

TEST(Kernel, LocalMatchOfSetsOfDifferentSizes) {
  // On a line, in units of 512: {0, 1/4} against {1/8}; every best match is 1/8 away.
  DescriptorSet two;
  append(two, 0);
  append(two, 128);
  DescriptorSet one;
  append(one, 64);
  const Kernel kernel(kernelOptions("local-match", 3));
  EXPECT_NEAR(kernel(two, one), std::exp(-3.0 / 64), 1e-15);

  // {0, 1/4} against {0}: best matches 0 and 1/4 one way, 0 the other.
  DescriptorSet zero;
  append(zero, 0);
  EXPECT_NEAR(kernel(two, zero), 0.5 * ((1 + std::exp(-3.0 / 16)) / 2 + 1), 1e-15);
  EXPECT_EQ(kernel(two, zero), kernel(zero, two));
}

std::string errorIn(const Kernel& kernel, const Feature& x, const Feature& y) {
  return errorOf([&] { kernel.measure(x, y); });
}

TEST(Kernel, RefusesWhatItHasNoMeaningFor) {
  RandomFeatures random(2);
  const Feature vector = random.dense(4);
  const Feature set = random.descriptors(2);
  const Kernel linear(kernelOptions("linear"));
  const Kernel local(kernelOptions("local-match"));
  const Kernel chi_squared(kernelOptions("chi-squared"));

  EXPECT_NE(errorIn(linear, set, set).find("use one of: local-match"), std::string::npos);
  EXPECT_NE(errorIn(local, vector, vector)
                .find("linear, polynomial, gaussian, sigmoid, "
                      "chi-squared, intersection"),
            std::string::npos);
  EXPECT_NE(errorIn(chi_squared, random.dense(4, -1, 0), vector).find("negative"),
            std::string::npos);
  EXPECT_NE(errorIn(linear, vector, random.dense(5)), "");
  EXPECT_NE(errorIn(linear, vector, SparseVector{{0}, {1}}), "");
  EXPECT_NE(errorIn(linear, Feature(), Feature()), "");
  EXPECT_NE(errorIn(local, DescriptorSet(), set), "");
}

TEST(Kernel, HasAGammaIfItsValuesDependOnIt) {
  RandomFeatures random(3);
  for (const char* type : {"linear", "polynomial", "gaussian", "sigmoid", "chi-squared",
                           "intersection", "local-match"}) {
    const bool for_sets = std::string(type) == "local-match";
    const Feature x = for_sets ? Feature(random.descriptors(2)) : random.dense(4);
    const Feature y = for_sets ? Feature(random.descriptors(2)) : random.dense(4);
    const double one = Kernel(kernelOptions(type, 1))(x, y);
    const double two = Kernel(kernelOptions(type, 2))(x, y);
    EXPECT_EQ(kernelOptions(type).hasGamma(), one != two) << type;
  }
  EXPECT_THROW(kernelOptions("cubic").hasGamma(), Error);
}

TEST(Kernel, OnlyLocalMatchNeedsGammaForItsMeasure) {
  for (const Expectation& kernel : kExpectations) {
    EXPECT_TRUE(Kernel(kernelOptions(kernel.type)).measureIsFreeOfGamma());
  }
  EXPECT_FALSE(Kernel(kernelOptions("local-match")).measureIsFreeOfGamma());
}

}  // namespace
}  // namespace place_recognition
