#include "experiments/reduction_curve.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace place_recognition {
namespace {

TEST(FewestVectors, IsTheFewestOfAnyPointThatKeepsTheShare) {
  const ReductionCurve curve = {{100, 0.8}, {80, 0.82}, {60, 0.7}, {40, 0.76}, {20, 0.5}};
  EXPECT_EQ(fewestVectors(curve, 1), 80);
  EXPECT_EQ(fewestVectors(curve, 0.95), 40);  // although 60 vectors keep less of it
  EXPECT_EQ(fewestVectors(curve, 0.6), 20);
  EXPECT_EQ(fewestVectors({curve, {{100, 0.8}, {10, 0.8}}}, 1), 10);
}

TEST(MeanCurve, EndsWithTheShortest) {
  const auto mean = meanCurve({{{10, 1.0}, {5, 0.5}, {1, 0.4}}, {{20, 0.8}, {15, 0.7}}});
  ASSERT_EQ(mean.size(), 2u);
  EXPECT_DOUBLE_EQ(mean[0].first, 1);
  EXPECT_DOUBLE_EQ(mean[0].second, 0.9);
  EXPECT_DOUBLE_EQ(mean[1].first, (0.5 + 0.75) / 2);
  EXPECT_DOUBLE_EQ(mean[1].second, 0.6);
}

TEST(PointAt, IsTheLastOneOfNoLargerTau) {
  const ReductionCurve curve = {{100, 0.8, 0}, {98, 0.8, 1e-9}, {80, 0.7, 0.1}, {60, 0.5, 0.2}};
  EXPECT_EQ(pointAt(curve, kExactTau)->vectors, 98);
  EXPECT_EQ(pointAt(curve, 0.15)->vectors, 80);
  EXPECT_EQ(pointAt(curve, 0.2)->vectors, 60);
  EXPECT_EQ(pointAt(curve, 0.3), nullptr);
}

TEST(ReductionCurve, DropsCopiesForNothing) {
  // Two vectors, each four times, under a linear kernel: K has rank two.
  Eigen::MatrixXd vectors(8, 2);
  BinarySvms machines;
  machines.places = 2;
  machines.weights.resize(8, 2);
  machines.biases = Eigen::RowVectorXd::Zero(2);
  for (int i = 0; i < 8; ++i) {
    vectors.row(i) << (i % 2 == 0 ? 1.0 : 0.2), (i % 2 == 0 ? 0.2 : 1.0);
    machines.weights.row(i) << (i % 2 == 0 ? 1 : -1), (i % 2 == 0 ? -1 : 1);
  }
  const Eigen::MatrixXd gram = vectors * vectors.transpose();
  const auto rate = [&](const BinarySvms& reduced) {
    const Eigen::MatrixXd change = reduced.decisionValues(gram) - machines.decisionValues(gram);
    return change.cwiseAbs().maxCoeff() < 1e-9 ? 1.0 : 0.0;
  };
  for (const char* method : {"qr", "shared-qr", "shared-greedy"}) {
    const ReductionCurve curve = reductionCurve(machines, gram, method, true, rate);
    EXPECT_EQ(curve.front().vectors, 8) << method;
    EXPECT_LE(fewestVectors(curve, 1), 2) << method;
    EXPECT_EQ(curve[1].tau, kExactTau);
    EXPECT_EQ(curve[1].vectors, 2) << method;
    EXPECT_EQ(curve[1].rate, 1) << method;
    const ReductionCurve again = curveFromJson(toJson(curve));
    EXPECT_EQ(again.size(), curve.size());
    EXPECT_EQ(again.back().vectors, curve.back().vectors);
  }
}

}  // namespace
}  // namespace place_recognition
