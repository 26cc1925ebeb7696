#include "learning/packed_gram.h"

#include <gtest/gtest.h>
#include <svm.h>

#include "learning/binary_svms.h"
#include "learning/gram.h"
#include "learning/random_features.h"

namespace place_recognition {
namespace {

std::vector<int> everyOther(int begin, int count) {
  std::vector<int> indices;
  for (int i = 0; i < count; ++i) indices.push_back(begin + 2 * i);
  return indices;
}

/// Returns a random matrix whose square part is symmetric.
Eigen::MatrixXd randomMeasures(Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd measures = Eigen::MatrixXd::Random(rows, columns).cwiseAbs();
  auto square = measures.topRows(columns);
  square = (square + square.transpose()).eval();
  return measures;
}

TEST(PackedGram, HoldsEveryValueWhereLibsvmReadsIt) {
  const Kernel kernel(kernelOptions("chi-squared", 0.7));
  for (const Eigen::Index rows : {1, 2, 33, 70}) {
    for (const Eigen::Index columns : {Eigen::Index{1}, (rows + 1) / 2, rows}) {
      const Eigen::MatrixXd measures = randomMeasures(rows, columns);
      const PackedGram gram(kernel, measures, 3);
      ASSERT_EQ(gram.rows(), rows);
      ASSERT_EQ(gram.columns(), columns);
      for (Eigen::Index i = 0; i < rows; ++i) {
        EXPECT_EQ(gram.nodes(i)[0].value, i + 1);
        for (Eigen::Index j = 0; j < columns; ++j) {
          EXPECT_EQ(gram(i, j), kernel.value(measures(i, j)));
          EXPECT_EQ(gram.nodes(i)[j + 1].value, gram(i, j));
        }
      }
    }
  }
}

TEST(PackedGram, GivesSomeRowsInSomeColumns) {
  const Eigen::MatrixXd values = randomMeasures(9, 7);
  const Eigen::MatrixXd part = PackedGram(values).values({8, 0, 3}, {6, 2});
  Eigen::MatrixXd expected(3, 2);
  expected << values(8, 6), values(8, 2), values(0, 6), values(0, 2), values(3, 6), values(3, 2);
  EXPECT_EQ(part, expected);
}

TEST(PackedGram, TrainsOnSomeVectorsAsOnAMatrixOfThem) {
  RandomFeatures random(3);
  std::vector<Feature> features;
  for (int i = 0; i < 90; ++i) features.push_back(random.dense(5));
  const Kernel kernel(kernelOptions("gaussian", 2));
  const Eigen::MatrixXd measures = measureMatrix(kernel, features, 1, {});
  const std::vector<int> vectors = everyOther(1, 41);
  std::vector<int> labels;
  for (std::size_t i = 0; i < vectors.size(); ++i) labels.push_back(static_cast<int>(i * i % 3));

  const PackedGram gram(kernel, measures, 1);
  for (const char* multiclass : {"one-against-all", "one-against-one"}) {
    SvmOptions options;
    options.multiclass = multiclass;
    const BinarySvms part = trainMachines(gram, vectors, labels, 3, options);
    const BinarySvms alone = trainMachines(gram.values(vectors, vectors), labels, 3, options);
    EXPECT_EQ(part.weights, alone.weights);
    EXPECT_EQ(part.biases, alone.biases);
    EXPECT_FALSE(supportVectors(part).empty());
  }
}

}  // namespace
}  // namespace place_recognition
