#include "learning/support_set.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "learning/gram.h"
#include "learning/random_features.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// A kernel on a kind of feature.
struct Case {
  const char* kernel;
  const char* kind;
  std::function<Feature(RandomFeatures&)> draw;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.kernel; }

class SupportSetOf : public testing::TestWithParam<Case> {
 protected:
  /// Kernel::measure is the reference, a plain implementation of the definition.
  void expectPlainMeasures(const SupportSet& set, const Feature& x) {
    const std::vector<Feature> vectors = set.vectors();
    Eigen::VectorXd measures(set.size());
    Eigen::VectorXd values(set.size());
    set.measures(x, measures);
    set.kernelValues(x, values);
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double expected = kernel_.measure(x, vectors[i]);
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(measures[row], expected, 1e-12 * (1 + std::abs(expected))) << "vector " << i;
      EXPECT_EQ(values[row], kernel_.value(measures[row]));
    }
  }

  static void expectEqual(const Feature& x, const Feature& y) {
    ASSERT_EQ(x.index(), y.index());
    if (const auto* sparse = std::get_if<SparseVector>(&x)) {
      EXPECT_EQ(sparse->indices, std::get<SparseVector>(y).indices);
      EXPECT_EQ(sparse->values, std::get<SparseVector>(y).values);
    } else if (const auto* dense = std::get_if<DenseVector>(&x)) {
      EXPECT_EQ(dense->values, std::get<DenseVector>(y).values);
    } else {
      EXPECT_EQ(std::get<DescriptorSet>(x).descriptors, std::get<DescriptorSet>(y).descriptors);
    }
  }

  std::vector<Feature> draw(std::size_t count) {
    std::vector<Feature> features;
    for (std::size_t i = 0; i < count; ++i) features.push_back(GetParam().draw(random_));
    return features;
  }

  RandomFeatures random_{3};
  Kernel kernel_{kernelOptions(GetParam().kernel, 5)};
};

TEST_P(SupportSetOf, EqualsThePlainKernel) {
  // More vectors than fit in one chunk of postings.
  const SupportSet set(kernel_, draw(500));
  for (const Feature& x : draw(5)) expectPlainMeasures(set, x);
  expectPlainMeasures(set, set.vectors()[7]);
}

TEST_P(SupportSetOf, WorksForAnyNumberOfVectors) {
  for (const std::size_t count : {0, 1, 2, 3, 17}) {
    const SupportSet set(kernel_, draw(count));
    expectPlainMeasures(set, GetParam().draw(random_));
  }
}

TEST_P(SupportSetOf, IsComparedWithItselfToTheSameBits) {
  for (const std::size_t count : {1, 2, 150}) {
    const std::vector<Feature> vectors = draw(count);
    const SupportSet set(kernel_, vectors);
    const Eigen::MatrixXd matrix = measureMatrix(kernel_, vectors, 2, {});
    Eigen::VectorXd measures(set.size());
    for (std::size_t i = 0; i < count; ++i) {
      set.measures(vectors[i], measures);
      const auto before = static_cast<Eigen::Index>(i + 1);
      EXPECT_EQ(matrix.col(static_cast<Eigen::Index>(i)).head(before), measures.head(before));
    }
  }
}

TEST_P(SupportSetOf, OwnMeasureIsExact) {
  const std::vector<Feature> vectors = draw(50);
  const SupportSet set(kernel_, vectors);
  Eigen::VectorXd measures(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) {
    set.measures(vectors[i], measures);
    const Measure measure = kernel_.type().measure;
    if (measure == Measure::kChiSquared || measure == Measure::kSquaredDistance) {
      EXPECT_EQ(measures[static_cast<Eigen::Index>(i)], 0);
      EXPECT_GE(measures.minCoeff(), 0);
    }
  }
}

TEST_P(SupportSetOf, GivesTheVectorsBack) {
  for (const std::size_t count : {0, 1, 40}) {
    const std::vector<Feature> vectors = draw(count);
    const std::vector<Feature> again = SupportSet(kernel_, vectors).vectors();
    ASSERT_EQ(again.size(), count);
    for (std::size_t i = 0; i < count; ++i) expectEqual(again[i], vectors[i]);
  }
}

const auto kHistogram = [](RandomFeatures& random) { return random.histogram(2000); };
const auto kDense = [](RandomFeatures& random) { return random.dense(37); };
const auto kSigned = [](RandomFeatures& random) { return random.dense(5, -1, 1); };
const auto kDescriptors = [](RandomFeatures& random) {
  return random.descriptors(static_cast<std::size_t>(random.uniform(1, 40)));
};

INSTANTIATE_TEST_SUITE_P(
    EveryKernel, SupportSetOf,
    testing::Values(Case{"linear", "Sparse", kHistogram}, Case{"polynomial", "Sparse", kHistogram},
                    Case{"gaussian", "Sparse", kHistogram}, Case{"sigmoid", "Sparse", kHistogram},
                    Case{"chi-squared", "Sparse", kHistogram},
                    Case{"intersection", "Sparse", kHistogram}, Case{"linear", "Dense", kDense},
                    Case{"gaussian", "Dense", kDense}, Case{"chi-squared", "Dense", kDense},
                    Case{"intersection", "Dense", kDense}, Case{"linear", "Signed", kSigned},
                    Case{"gaussian", "Signed", kSigned},
                    Case{"local-match", "Descriptors", kDescriptors}),
    [](const testing::TestParamInfo<Case>& info) {
      std::string name = std::string(info.param.kind) + "_" + info.param.kernel;
      for (char& c : name) c = c == '-' ? '_' : c;
      return name;
    });

TEST(SupportSet, TakesEdgesOfSparseVectors) {
  const std::vector<Feature> vectors = {SparseVector{},
                                        SparseVector{{0, ~std::uint64_t{0}}, {0.5f, 0.5f}},
                                        SparseVector{{0}, {1}}, SparseVector{{1}, {1e-30f}}};
  const Kernel kernel(kernelOptions("chi-squared"));
  const SupportSet set(kernel, vectors);
  Eigen::VectorXd measures(4);
  for (const Feature& x : vectors) {
    set.measures(x, measures);
    for (Eigen::Index i = 0; i < 4; ++i) {
      EXPECT_NEAR(measures[i], kernel.measure(x, vectors[static_cast<std::size_t>(i)]), 1e-15);
    }
  }
}

TEST(SupportSet, DescriptorsOfGreatestDistanceAreExact) {
  DescriptorSet black;
  black.descriptors.assign(3 * DescriptorSet::kDimension, 0);
  DescriptorSet white;
  white.descriptors.assign(5 * DescriptorSet::kDimension, 255);
  const Kernel kernel(kernelOptions("local-match", 0.5));
  const SupportSet set(kernel, {black, white});
  Eigen::VectorXd values(2);
  set.measures(white, values);
  EXPECT_NEAR(values[0], std::exp(-0.5 * 128 * 255 * 255 / (512.0 * 512)), 1e-15);
  EXPECT_EQ(values[1], 1);
}

TEST(SupportSet, RefusesForeignFeatures) {
  RandomFeatures random(4);
  const Kernel kernel(kernelOptions("linear"));
  EXPECT_THROW(SupportSet(kernel, {random.dense(3), random.dense(4)}), Error);
  EXPECT_THROW(SupportSet(kernel, {random.dense(3), random.histogram(4)}), Error);
  EXPECT_THROW(SupportSet(kernel, {random.descriptors(1)}), Error);
  EXPECT_THROW(SupportSet(kernel, {Feature()}), Error);
  EXPECT_THROW(SupportSet(Kernel(kernelOptions("intersection")), {random.dense(3, -1, 0)}), Error);

  Eigen::VectorXd out(1);
  const SupportSet dense(kernel, {random.dense(3)});
  EXPECT_THROW(dense.measures(random.dense(4), out), Error);
  EXPECT_THROW(dense.measures(random.histogram(4), out), Error);
  const SupportSet local(Kernel(kernelOptions("local-match")), {random.descriptors(2)});
  EXPECT_THROW(local.measures(random.dense(4), out), Error);
  EXPECT_THROW(local.measures(DescriptorSet(), out), Error);
}

}  // namespace
}  // namespace place_recognition
