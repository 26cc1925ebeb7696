#include "place_recognition/classifier.h"

#include <gtest/gtest.h>

#include "learning/classifier_parts.h"
#include "learning/random_features.h"

namespace place_recognition {
namespace {

TEST(Classifier, DecisionValuesAreTheDirectSum) {
  RandomFeatures random(7);
  const Kernel kernel(kernelOptions("chi-squared", 2));
  std::vector<Feature> vectors;
  for (int i = 0; i < 30; ++i) vectors.push_back(random.histogram(500));
  BinarySvms machines;
  machines.places = 3;
  machines.weights = Eigen::MatrixXd::Random(30, 3);
  machines.weights.row(4).setZero();
  machines.weights.row(29).setZero();
  machines.biases = Eigen::RowVector3d(0.5, -0.25, 0);

  const Classifier classifier = ClassifierParts::assemble(
      kernel.options(), machines, vectors, std::vector<VectorOrigin>(vectors.size()));
  EXPECT_EQ(classifier.places(), 3u);
  EXPECT_EQ(classifier.supportVectorCount(), 28u);
  EXPECT_EQ(ClassifierParts::of(classifier).machines.weights.rows(), 28);

  const Feature x = random.histogram(500);
  Eigen::RowVectorXd expected = machines.biases;
  for (int i = 0; i < 30; ++i) expected += machines.weights.row(i) * kernel(x, vectors[i]);
  Eigen::VectorXd scratch;
  Eigen::RowVectorXd decision_values;
  classifier.decisionValues(x, scratch, decision_values);
  EXPECT_TRUE(decision_values.isApprox(expected, 1e-12));
}

TEST(Classifier, WithoutAnyVectorAnswersItsBias) {
  RandomFeatures random(8);
  BinarySvms machines;
  machines.places = 2;
  machines.weights = Eigen::MatrixXd::Zero(1, 2);
  machines.biases = Eigen::RowVector2d(1, -1);
  const Classifier classifier = ClassifierParts::assemble(kernelOptions("linear"), machines,
                                                          {random.dense(3)}, {VectorOrigin()});
  EXPECT_EQ(classifier.supportVectorCount(), 0u);
  Eigen::VectorXd scratch;
  Eigen::RowVectorXd decision_values;
  classifier.decisionValues(random.dense(3), scratch, decision_values);
  EXPECT_EQ(decision_values, machines.biases);
}

}  // namespace
}  // namespace place_recognition
