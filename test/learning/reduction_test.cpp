#include "learning/reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "learning/gram.h"
#include "learning/random_features.h"
#include "learning/thesis_reduction.h"

namespace place_recognition {
namespace {

/// BinarySvms trained on points of the plane, place 0 within a band and place 1 around it, with
/// noise.
struct Plane {
  std::vector<Feature> points;
  Eigen::MatrixXd gram;
  BinarySvms machines;

  Plane(const std::string& kernel_type, int places, const std::string& multiclass) {
    RandomFeatures random(10);
    std::vector<int> labels;
    for (int i = 0; i < 120; ++i) {
      const double x = random.uniform(-1, 1);
      const double y = random.uniform(-1, 1);
      points.push_back(point(x, y));
      const double noisy = x + 0.5 * y * y + random.uniform(-0.4, 0.4);
      labels.push_back(std::clamp(static_cast<int>((noisy + 1) / 2 * places), 0, places - 1));
    }
    const Kernel kernel(kernelOptions(kernel_type, 1));
    gram = gramMatrix(kernel, measureMatrix(kernel, points, 1, {}));
    SvmOptions options;
    options.c = 1;
    options.multiclass = multiclass;
    machines = trainMachines(gram, labels, static_cast<std::size_t>(places), options);
  }

  double changeOf(const BinarySvms& reduced) const {
    return (reduced.decisionValues(gram) - machines.decisionValues(gram)).cwiseAbs().maxCoeff();
  }
};

ReductionOptions reduction(const std::string& method, double tau, bool normalize = true,
                           int support_vectors = 0) {
  ReductionOptions options;
  options.method = method;
  options.tau = tau;
  options.normalize = normalize;
  options.support_vectors = support_vectors;
  return options;
}

std::size_t count(const BinarySvms& machines) { return supportVectors(machines).size(); }

class Method : public testing::TestWithParam<const char*> {};

TEST_P(Method, LeavesTwoVectorsOfALinearKernelInThePlane) {
  const Plane plane("linear", 2, "one-against-one");
  ASSERT_GT(count(plane.machines), 20u);
  for (const bool normalize : {true, false}) {
    const BinarySvms reduced =
        reduce(plane.machines, plane.gram, reduction(GetParam(), 1e-8, normalize));
    EXPECT_EQ(count(reduced), 2u);
    EXPECT_LT(plane.changeOf(reduced), 1e-9);
  }
}

TEST_P(Method, KeepsTheDecisionsOfAPolynomialKernel) {
  for (const char* multiclass : {"one-against-all", "one-against-one"}) {
    const Plane plane("polynomial", 3, multiclass);
    ASSERT_GT(count(plane.machines), 50u);
    for (const bool normalize : {true, false}) {
      const BinarySvms reduced =
          reduce(plane.machines, plane.gram, reduction(GetParam(), 1e-10, normalize));
      // Ten monomials of degree up to 3 in two variables, for each machine or for all.
      EXPECT_LE(count(reduced), GetParam() == std::string("qr") ? 30u : 10u);
      EXPECT_LT(plane.changeOf(reduced), 1e-6);
      for (Eigen::Index m = 0; m < 3; ++m) {
        EXPECT_LE((reduced.weights.col(m).array() != 0).count(), 10);
      }
    }
  }
}

TEST_P(Method, NeverAddsVectors) {
  const Plane plane("gaussian", 3, "one-against-all");
  const std::vector<int> before = supportVectors(plane.machines);
  std::size_t last = before.size();
  for (const double tau : {0.0, 1e-12, 1e-6, 1e-3, 0.1, 1.0}) {
    const BinarySvms reduced = reduce(plane.machines, plane.gram, reduction(GetParam(), tau));
    const std::vector<int> after = supportVectors(reduced);
    EXPECT_LE(after.size(), last) << tau;
    EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end()));
    EXPECT_EQ(reduced.biases, plane.machines.biases);
    last = after.size();
  }
}

TEST_P(Method, KeepsAsManyVectorsAsAsked) {
  const Plane plane("gaussian", 3, "one-against-all");
  const int before = static_cast<int>(count(plane.machines));
  double change = 1e9;
  for (const int wanted : {1, 2, 5, 10, 20, before, before + 5}) {
    const BinarySvms reduced =
        reduce(plane.machines, plane.gram, reduction(GetParam(), 0.5, true, wanted));
    const int kept = static_cast<int>(count(reduced));
    EXPECT_LE(kept, wanted);
    if (wanted <= 20) {
      EXPECT_GE(kept, GetParam() == std::string("qr") ? wanted - 2 : wanted);
    }
    change = plane.changeOf(reduced);
  }
  EXPECT_LT(change, 1e-6);
}

TEST_P(Method, HoldsEveryReductionToFewerVectors) {
  const Plane plane("gaussian", 3, "one-against-one");
  const auto all = factorize(plane.machines, plane.gram, reduction(GetParam(), 0.5, true, 60));
  for (const int vectors : {1, 3, 17, 40, 60}) {
    const BinarySvms alone =
        reduce(plane.machines, plane.gram, reduction(GetParam(), 0.5, true, vectors));
    EXPECT_TRUE(all->withVectors(vectors).weights == alone.weights) << vectors;
  }
}

TEST_P(Method, HoldsEveryReductionByTau) {
  const Plane plane("gaussian", 3, "one-against-one");
  const auto all = factorize(plane.machines, plane.gram,
                             reduction(GetParam(), 0.5, true, count(plane.machines)));
  for (const double tau : {1e-9, 1e-5, 1e-3, 0.05, 0.4}) {
    const BinarySvms alone = reduce(plane.machines, plane.gram, reduction(GetParam(), tau));
    EXPECT_TRUE(all->withTau(tau).weights == alone.weights) << tau;
  }
  const std::vector<double> thresholds = all->thresholds();
  ASSERT_GT(thresholds.size(), 10u);
  EXPECT_TRUE(std::is_sorted(thresholds.rbegin(), thresholds.rend()));
  EXPECT_EQ(thresholds.front(), 1);
  // Just below a threshold, its vector is kept; at the threshold, it is not.
  const auto weights = [&](double tau) { return (all->withTau(tau).weights.array() != 0).count(); };
  EXPECT_GT(weights(thresholds[5] * (1 - 1e-9)), weights(thresholds[5]));
}

TEST_P(Method, KeepsTheShareOfVectorsAsked) {
  const Plane plane("gaussian", 3, "one-against-all");
  ReductionOptions options = reduction(GetParam(), 0.5);
  options.share = 0.25;
  const double quarter = 0.25 * static_cast<double>(count(plane.machines));
  const std::size_t kept = count(reduce(plane.machines, plane.gram, options));
  EXPECT_LE(kept, std::ceil(quarter));
  EXPECT_GE(kept, std::ceil(quarter) - 2);
}

TEST_P(Method, ReportsProgressAndStops) {
  const Plane plane("gaussian", 2, "one-against-all");
  double last = -1;
  reduce(plane.machines, plane.gram, reduction(GetParam(), 1e-3),
         [&](const std::string&, double fraction) {
           EXPECT_GE(fraction, last);
           EXPECT_LE(fraction, 1);
           last = fraction;
           return true;
         });
  EXPECT_GT(last, 0);
  EXPECT_THROW(reduce(plane.machines, plane.gram, reduction(GetParam(), 1e-3),
                      [](const std::string&, double) { return false; }),
               Cancelled);
}

INSTANTIATE_TEST_SUITE_P(Every, Method, testing::Values("qr", "shared-qr", "shared-greedy"),
                         [](const testing::TestParamInfo<const char*>& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Reduction, QrIsThatOfTheThesis) {
  for (const char* kernel : {"linear", "gaussian", "polynomial"}) {
    const Plane plane(kernel, 3, "one-against-all");
    for (const double tau : {1e-6, 1e-3, 0.05}) {
      for (const bool normalize : {true, false}) {
        const BinarySvms reduced =
            reduce(plane.machines, plane.gram, reduction("qr", tau, normalize));
        for (Eigen::Index m = 0; m < 3; ++m) {
          const Eigen::VectorXd expected =
              thesisReduction(plane.gram, plane.machines.weights.col(m), tau, normalize);
          EXPECT_LT((reduced.weights.col(m) - expected).norm(), 1e-6 * expected.norm())
              << kernel << " " << tau << " " << normalize;
        }
      }
    }
  }
}

TEST(Reduction, SharedWeightsAreLeastSquares) {
  const Plane plane("gaussian", 4, "one-against-one");
  for (const char* method : {"shared-qr", "shared-greedy"}) {
    const BinarySvms reduced = reduce(plane.machines, plane.gram, reduction(method, 0, true, 6));
    const Eigen::MatrixXd residual = plane.gram * (plane.machines.weights - reduced.weights);
    for (const int vector : supportVectors(reduced)) {
      const Eigen::RowVectorXd products = plane.gram.col(vector).transpose() * residual;
      EXPECT_LT(products.norm(), 1e-9 * plane.gram.col(vector).norm()) << method;
    }
  }
}

TEST(Reduction, GreedyStopsAtTheResidualOfTau) {
  const Plane plane("gaussian", 3, "one-against-all");
  const Eigen::MatrixXd decision_values = plane.gram * plane.machines.weights;
  const double tau = 0.02;
  const auto gap = [&](const BinarySvms& reduced) {
    return (decision_values - plane.gram * reduced.weights).norm() / decision_values.norm();
  };
  const BinarySvms reduced = reduce(plane.machines, plane.gram, reduction("shared-greedy", tau));
  const int kept = static_cast<int>(count(reduced));
  EXPECT_LE(gap(reduced), tau);
  EXPECT_EQ(count(reduce(plane.machines, plane.gram, reduction("shared-greedy", 1))), 1u);
  EXPECT_GT(
      gap(reduce(plane.machines, plane.gram, reduction("shared-greedy", tau, true, kept - 1))),
      tau);
}

TEST(Reduction, OfSeveralVariantsIsThatOfEach) {
  const Plane plane("gaussian", 3, "one-against-all");
  std::vector<ReductionOptions> variants{reduction("none", 0)};
  for (const char* method : {"shared-greedy", "qr"}) {
    for (const int vectors : {30, 12, 4}) {
      variants.push_back(reduction(method, 0, true, vectors));
    }
  }
  for (const unsigned threads : {1u, 3u}) {
    const std::vector<BinarySvms> reduced =
        reduceEach(plane.machines, plane.gram, variants, threads);
    ASSERT_EQ(reduced.size(), variants.size());
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const BinarySvms alone = reduce(plane.machines, plane.gram, variants[i]);
      EXPECT_TRUE(reduced[i].weights == alone.weights) << i;
    }
  }
}

TEST(Reduction, NoneKeepsTheMachines) {
  const Plane plane("gaussian", 2, "one-against-all");
  const BinarySvms same = reduce(plane.machines, plane.gram, reduction("none", 0.5, true, 1));
  EXPECT_TRUE(same.weights == plane.machines.weights);
}

TEST(Reduction, TakesMachinesWithoutVectors) {
  BinarySvms machines;
  machines.places = 2;
  machines.weights = Eigen::MatrixXd::Zero(3, 2);
  machines.biases = Eigen::RowVector2d(1, -1);
  for (const char* method : {"qr", "shared-qr", "shared-greedy"}) {
    const BinarySvms reduced =
        reduce(machines, Eigen::MatrixXd::Ones(3, 3), reduction(method, 0.1));
    EXPECT_TRUE(reduced.weights.isZero(0));
  }
  // One machine of two has vectors, all of them the same.
  machines.weights.col(0) << 1, 2, -4;
  for (const char* method : {"qr", "shared-qr", "shared-greedy"}) {
    const BinarySvms reduced =
        reduce(machines, Eigen::MatrixXd::Ones(3, 3), reduction(method, 0.1));
    EXPECT_EQ(count(reduced), 1u);
    EXPECT_NEAR(reduced.weights.col(0).sum(), -1, 1e-12);
  }
}

}  // namespace
}  // namespace place_recognition
