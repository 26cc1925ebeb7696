#include "learning/binary_svms.h"

#include <gtest/gtest.h>
#include <svm.h>

#include <memory>

#include "learning/gram.h"
#include "learning/random_features.h"

namespace place_recognition {
namespace {

/// Dense vectors of `places` overlapping clouds.
struct Clouds {
  std::vector<Feature> features;
  std::vector<int> labels;

  Clouds(std::size_t count, int places) {
    RandomFeatures random(6);
    for (std::size_t i = 0; i < count; ++i) {
      const int place = static_cast<int>(i) % places;
      DenseVector vector = random.dense(4);
      vector.values[static_cast<std::size_t>(place % 4)] += 0.5f;
      features.push_back(vector);
      labels.push_back(place);
    }
  }

  Eigen::MatrixXd gram() const {
    const Kernel kernel(kernelOptions("gaussian", 2));
    return gramMatrix(kernel, measureMatrix(kernel, features, 1, {}));
  }
};

SvmOptions svmOptions(double c, const std::string& multiclass) {
  SvmOptions options;
  options.c = c;
  options.multiclass = multiclass;
  return options;
}

const SvmOptions kAll = svmOptions(10, "one-against-all");
const SvmOptions kPairs = svmOptions(10, "one-against-one");

TEST(BinarySvms, FindsTheWidestDecisionValue) {
  // On a line: -3 and -1 against 1 and 4: f(x) = x, support vectors -1 and 1 with alpha 1/2.
  const std::vector<Feature> features = {point(-3, 0), point(-1, 0), point(1, 0), point(4, 0)};
  const Kernel kernel(kernelOptions("linear"));
  const Eigen::MatrixXd gram = gramMatrix(kernel, measureMatrix(kernel, features, 1, {}));
  const BinarySvms machines = trainMachines(gram, {0, 0, 1, 1}, 2, kAll);
  EXPECT_TRUE(machines.weights.col(1).isApprox(Eigen::Vector4d(0, -0.5, 0.5, 0), 1e-3));
  EXPECT_NEAR(machines.biases[1], 0, 1e-3);
  EXPECT_TRUE(machines.weights.col(0).isApprox(-machines.weights.col(1), 1e-3));
  EXPECT_EQ(supportVectors(machines), std::vector<int>({1, 2}));
}

TEST(BinarySvms, MeetTheConditionsOfOptimality) {
  const Clouds clouds(120, 3);
  const Eigen::MatrixXd gram = clouds.gram();
  const BinarySvms machines = trainMachines(gram, clouds.labels, 3, kAll);
  const Eigen::MatrixXd decision_values = machines.decisionValues(gram);
  for (Eigen::Index m = 0; m < 3; ++m) {
    EXPECT_NEAR(machines.weights.col(m).sum(), 0, 1e-9);
    for (Eigen::Index i = 0; i < 120; ++i) {
      const double sign = clouds.labels[static_cast<std::size_t>(i)] == m ? 1 : -1;
      const double alpha = sign * machines.weights(i, m);
      const double decision_value = sign * decision_values(i, m);
      EXPECT_GE(alpha, 0);
      EXPECT_LE(alpha, kAll.c);
      if (alpha < kAll.c) {
        EXPECT_GT(decision_value, 1 - 1e-2);
      }
      if (alpha > 0) {
        EXPECT_LT(decision_value, 1 + 1e-2);
      }
    }
  }
}

struct ModelDeleter {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};

/// Returns libsvm's decision values for `place` against the rest.
Eigen::VectorXd libsvmDecisionValues(const Eigen::MatrixXd& gram, const std::vector<int>& labels,
                                     int place, double c) {
  const Eigen::Index n = gram.rows();
  std::vector<std::vector<svm_node>> rows;
  std::vector<svm_node*> row_pointers;
  std::vector<double> signs;
  for (Eigen::Index i = 0; i < n; ++i) {
    std::vector<svm_node>& row = rows.emplace_back();
    row.push_back({0, static_cast<double>(i + 1)});
    for (Eigen::Index j = 0; j < n; ++j) row.push_back({static_cast<int>(j + 1), gram(i, j)});
    signs.push_back(labels[static_cast<std::size_t>(i)] == place ? 1 : -1);
  }
  for (std::vector<svm_node>& row : rows) row_pointers.push_back(row.data());
  svm_problem problem = {static_cast<int>(n), signs.data(), row_pointers.data()};
  svm_parameter parameter = {};
  parameter.kernel_type = PRECOMPUTED;
  parameter.cache_size = 10;
  parameter.eps = 1e-4;
  parameter.C = c;
  parameter.shrinking = 1;
  const std::unique_ptr<svm_model, ModelDeleter> model(svm_train(&problem, &parameter));
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    svm_predict_values(model.get(), row_pointers[static_cast<std::size_t>(i)], &values[i]);
  }
  return model->label[0] * values;
}

TEST(BinarySvms, DecisionValuesAreThoseOfLibsvm) {
  const Clouds clouds(90, 3);
  const Eigen::MatrixXd gram = clouds.gram();
  const Eigen::MatrixXd decision_values =
      trainMachines(gram, clouds.labels, 3, kAll).decisionValues(gram);
  for (int place = 0; place < 3; ++place) {
    const Eigen::VectorXd expected = libsvmDecisionValues(gram, clouds.labels, place, kAll.c);
    EXPECT_LT((decision_values.col(place) - expected).norm(), 1e-9 * expected.norm());
  }
}

TEST(BinarySvms, ArePositiveForTheFirstOfAPair) {
  const Clouds clouds(120, 3);
  const Eigen::MatrixXd gram = clouds.gram();
  const BinarySvms machines = trainMachines(gram, clouds.labels, 3, kPairs);
  const Eigen::MatrixXd decision_values = machines.decisionValues(gram);
  const int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  ASSERT_EQ(decision_values.cols(), 3);
  for (Eigen::Index m = 0; m < 3; ++m) {
    double right = 0;
    for (Eigen::Index i = 0; i < 120; ++i) {
      const int place = clouds.labels[static_cast<std::size_t>(i)];
      if (place == pairs[m][0]) right += decision_values(i, m) > 0;
      if (place == pairs[m][1]) right += decision_values(i, m) < 0;
      if (place != pairs[m][0] && place != pairs[m][1]) {
        EXPECT_EQ(machines.weights(i, m), 0);
      }
    }
    EXPECT_GT(right / 80, 0.8);
  }
}

TEST(BinarySvms, DoNotDependOnThreads) {
  const Clouds clouds(100, 5);
  const Eigen::MatrixXd gram = clouds.gram();
  for (const SvmOptions& options : {kAll, kPairs}) {
    const BinarySvms one = trainMachines(gram, clouds.labels, 5, options, 1);
    const BinarySvms four = trainMachines(gram, clouds.labels, 5, options, 4);
    EXPECT_TRUE(one.weights == four.weights);
    EXPECT_TRUE(one.biases == four.biases);
  }
}

TEST(BinarySvms, OfASingleSignAnswerIt) {
  // Place 2 of 3 has no vectors.
  const Clouds clouds(40, 2);
  const Eigen::MatrixXd gram = clouds.gram();
  const BinarySvms all = trainMachines(gram, clouds.labels, 3, kAll);
  EXPECT_TRUE(all.weights.col(2).isZero(0));
  EXPECT_EQ(all.biases[2], -1);

  const BinarySvms pairs = trainMachines(gram, clouds.labels, 3, kPairs);
  EXPECT_EQ(pairs.biases[1], 1);  // 0 against 2
  EXPECT_EQ(pairs.biases[2], 1);  // 1 against 2

  const BinarySvms only = trainMachines(gram.topLeftCorner(1, 1), {1}, 2, kAll);
  EXPECT_EQ(only.biases, Eigen::RowVector2d(-1, 1));
}

TEST(BinarySvms, AddInTheSameOrderOnEveryProcessor) {
  EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);  // Eigen cuts sums accordingly
}

TEST(BinarySvms, VotesAndTies) {
  BinarySvms machines;
  machines.places = 3;
  machines.one_against_one = true;
  Eigen::MatrixXd decision_values(3, 3);  // (0,1), (0,2), (1,2)
  decision_values << 1, 2, 3,             // place 0 beats both
      1, -2, 4,                           // a cycle: sums -1, 3, -2
      1e9, -1e-9, 1e-9;                   // a cycle of very unequal decision values
  const Eigen::MatrixXd votes = placeValues(machines, decision_values);
  const auto squash = [](double sum) { return sum / (3 * (std::abs(sum) + 1)); };
  EXPECT_NEAR(votes(0, 0), 2 + squash(3), 1e-15);
  EXPECT_NEAR(votes(0, 1), 1 + squash(2), 1e-15);
  EXPECT_NEAR(votes(0, 2), 0 + squash(-5), 1e-15);
  Eigen::Index winner = 0;
  votes.row(1).maxCoeff(&winner);
  EXPECT_EQ(winner, 1);
  // A tie-break never outweighs a vote.
  EXPECT_LT(votes.row(2).maxCoeff() - votes.row(2).minCoeff(), 1);

  machines.one_against_one = false;
  EXPECT_TRUE(placeValues(machines, decision_values) == decision_values);
  EXPECT_EQ(machineCount(5, true), 10u);
  EXPECT_EQ(machineCount(5, false), 5u);
}

}  // namespace
}  // namespace place_recognition
