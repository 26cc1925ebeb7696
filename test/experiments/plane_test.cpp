#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "experiments/plane_drawing.h"
#include "experiments/plane_problem.h"

namespace place_recognition {
namespace {

KernelOptions ofType(const char* type) {
  KernelOptions kernel;
  kernel.type = type;
  return kernel;
}

/// f(x) = weight K((x, y), .) + bias.
PlaneMachine machineOfOne(const KernelOptions& kernel, double weight, double bias) {
  BinarySvms svms;
  svms.places = 2;
  svms.one_against_one = true;
  svms.weights = Eigen::MatrixXd::Constant(1, 1, weight);
  svms.biases = Eigen::RowVectorXd::Constant(1, bias);
  return {{0}, svms, kernel};
}

/// Returns the fraction of the square inside a contour.
double fractionOf(const std::vector<cv::Point>& contour) {
  return cv::contourArea(contour) / (DecisionRegions::kSize * DecisionRegions::kSize);
}

/// Expects that a reduction that is exact up to rounding leaves `rank` vectors and does not change
/// the discriminant function.
void expectRank(const KernelOptions& kernel, std::size_t rank) {
  const PlanePoints points = planePoints(PlaneBorder::kLine);
  const PlaneMachine machine = trainInPlane(points, kernel, 100);
  const PlaneMachine reduced = reduceInPlane(points, machine, 1e-8);
  EXPECT_GT(machine.vectors.size(), 2 * rank);
  EXPECT_EQ(reduced.vectors.size(), rank);
  EXPECT_LT(
      cv::norm(planeValues(points, machine, 20), planeValues(points, reduced, 20), cv::NORM_INF),
      1e-9);
}

TEST(Plane, LinearMachineNeedsTwoVectors) { expectRank(ofType("linear"), 2); }

TEST(Plane, CubicMachineNeedsAsManyVectorsAsThereAreMonomials) {
  KernelOptions kernel = ofType("polynomial");
  kernel.p = 1;
  kernel.d = 3;
  expectRank(kernel, 10);  // 1, x, y, x^2 ... y^3
}

TEST(Plane, RegionsLieOnTheirSidesOfALine) {
  // f(x, y) = 2 x - 0.5 is positive right of 1/4 and above 1 right of 3/4.
  const PlanePoints points{{DenseVector{{1, 0}}}, {0}};
  const DecisionRegions regions = decisionRegions(points, machineOfOne(ofType("linear"), 2, -0.5));
  ASSERT_EQ(regions.above[0].size(), 1u);
  EXPECT_NEAR(fractionOf(regions.above[0][0]), 0.75, 0.01);
  ASSERT_EQ(regions.above[2].size(), 1u);
  EXPECT_NEAR(fractionOf(regions.above[2][0]), 0.25, 0.01);
  EXPECT_TRUE(regions.above[3].empty());
  EXPECT_TRUE(regions.below[2].empty());
}

TEST(Plane, ARegionMayHaveAHole) {
  // f = 0.5 - exp(-10 r^2) is negative within r^2 = ln 2 / 10 of the centre.
  const PlanePoints points{{DenseVector{{0.5f, 0.5f}}}, {0}};
  KernelOptions kernel = ofType("gaussian");
  kernel.gamma = 10;
  const DecisionRegions regions = decisionRegions(points, machineOfOne(kernel, -1, 0.5));
  ASSERT_EQ(regions.above[0].size(), 2u);
  EXPECT_NEAR(fractionOf(regions.above[0][0]), 1, 0.01);
  EXPECT_NEAR(fractionOf(regions.above[0][1]), M_PI * std::log(2) / 10, 0.01);
}

}  // namespace
}  // namespace place_recognition
