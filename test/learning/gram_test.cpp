#include "learning/gram.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "learning/random_features.h"

namespace place_recognition {
namespace {

std::vector<Feature> histograms(std::size_t count) {
  RandomFeatures random(5);
  std::vector<Feature> features;
  for (std::size_t i = 0; i < count; ++i) features.push_back(random.histogram(300));
  return features;
}

TEST(Gram, EqualsThePlainKernelAcrossBlocks) {
  const std::vector<Feature> features = histograms(1100);
  const Kernel kernel(kernelOptions("chi-squared"));
  const Eigen::MatrixXd measures = measureMatrix(kernel, features, 2, {});
  EXPECT_TRUE(measures == measures.transpose());
  for (std::size_t i = 0; i < features.size(); i += 37) {
    for (std::size_t j = 0; j < features.size(); j += 7) {
      EXPECT_NEAR(measures(i, j), kernel.measure(features[i], features[j]), 1e-12);
    }
  }
  EXPECT_EQ(gramMatrix(kernel, measures)(3, 1099), kernel.value(measures(3, 1099)));
}

TEST(Gram, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Feature> features = histograms(80);
  const Kernel kernel(kernelOptions("chi-squared"));
  EXPECT_TRUE(measureMatrix(kernel, features, 1, {}) == measureMatrix(kernel, features, 5, {}));
  EXPECT_EQ(measureMatrix(kernel, {}, 2, {}).size(), 0);
}

TEST(Gram, OfMercerKernelsIsPositiveSemidefinite) {
  std::vector<Feature> features = histograms(150);
  features.insert(features.end(), features.begin(), features.begin() + 50);  // singular, too
  for (const char* type : {"linear", "polynomial", "gaussian", "chi-squared", "intersection"}) {
    for (const double gamma : {0.01, 1.0, 30.0}) {
      const Kernel kernel(kernelOptions(type, gamma));
      const Eigen::MatrixXd gram = gramMatrix(kernel, measureMatrix(kernel, features, 2, {}));
      const Eigen::VectorXd eigenvalues =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram, Eigen::EigenvaluesOnly)
              .eigenvalues();
      EXPECT_GT(eigenvalues.minCoeff(), -1e-9 * eigenvalues.maxCoeff()) << type << " " << gamma;
    }
  }
}

TEST(Gram, ReportsProgressAndStops) {
  const std::vector<Feature> features = histograms(40);
  const Kernel kernel(kernelOptions("linear"));
  double last = 0;
  measureMatrix(kernel, features, 1, [&](const std::string&, double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_THROW(measureMatrix(kernel, features, 1, [](const std::string&, double) { return false; }),
               Cancelled);
}

}  // namespace
}  // namespace place_recognition
