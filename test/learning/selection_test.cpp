#include "learning/selection.h"

#include <gtest/gtest.h>

namespace place_recognition {
namespace {

TEST(Selection, PicksInTheOrderOfTheIndices) {
  EXPECT_EQ(pick(std::vector<char>{'a', 'b', 'c'}, {2, 0, 2}), (std::vector<char>{'c', 'a', 'c'}));
  Eigen::MatrixXd matrix(2, 3);
  matrix << 1, 2, 3,  //
      4, 5, 6;
  Eigen::MatrixXd turned(2, 3), columns(2, 2);
  turned << 4, 5, 6,  //
      1, 2, 3;
  columns << 3, 1,  //
      6, 4;
  EXPECT_EQ(pickRows(matrix, {1, 0}), turned);
  EXPECT_EQ(pickColumns(matrix, {2, 0}), columns);
  EXPECT_EQ(submatrix(matrix, {1}, {2, 0}), columns.bottomRows(1));
}

TEST(Selection, MayBeEmpty) {
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(2, 3);
  EXPECT_TRUE(pick(std::vector<int>{1, 2}, {}).empty());
  EXPECT_EQ(pickRows(matrix, {}).cols(), 3);
  EXPECT_EQ(pickColumns(matrix, {}).rows(), 2);
  EXPECT_EQ(submatrix(matrix, {}, {}).size(), 0);
}

}  // namespace
}  // namespace place_recognition
