#include "experiments/materials_tables.h"

#include <gtest/gtest.h>

#include "experiments/material_grid.h"

namespace place_recognition {
namespace {

/// The whole grid; `rate` and `validation` of each classifier.
template <typename RateOf>
std::vector<MaterialResult> grid(const RateOf& rate_of) {
  std::vector<MaterialResult> results;
  for (const char* feature : kMaterialFeatures) {
    for (const int samples : {1, 2, 3}) {
      for (const KernelOptions& kernel : materialKernels()) {
        for (const SvmOptions& svm : materialSvms()) {
          MaterialResult& result = results.emplace_back();
          result.classifier = {feature, samples, kernel, svm};
          for (const double change : {-0.01, 0.01}) {
            MaterialOutcome& outcome = result.outcomes.emplace_back();
            outcome.rate = rate_of(result.classifier) + change;
            outcome.validation = outcome.rate;
            outcome.vectors = 100;
            outcome.fewest = {80, 70, 60, 50, 40};
            outcome.curve = {{100, outcome.rate, 0}};
            outcome.taus = {{0.1, 50}};
          }
        }
      }
    }
  }
  return results;
}

const Table& tableOf(const Findings& findings, const std::string& name) {
  for (const Table& table : findings.tables) {
    if (table.name == name) return table;
  }
  throw std::runtime_error(name);
}

TEST(MaterialTables, RejectClassifiersBelow30PerCent) {
  // Only Gaussian kernels with gamma 10 are below.
  const Findings findings = materialFindings(grid([](const MaterialClassifier& classifier) {
    return classifier.kernel.type == "gaussian" && classifier.kernel.gamma == 10 ? 0.29 : 0.31;
  }));
  const Table& table = tableOf(findings, "table_7_1");
  EXPECT_EQ(table.rows[4][0], "gaussian gamma=1");
  EXPECT_EQ(table.rows[4][1], "31.00 +- 1.41");
  EXPECT_EQ(table.rows[5][0], "rejected: below 30 %");
  EXPECT_EQ(table.rows[5][1], "");
  const Table& all = tableOf(findings, "table_7_grid");
  ASSERT_EQ(all.rows.size(), 1u + 3 * 3);
  EXPECT_EQ(all.rows[1][2], "192");
  EXPECT_EQ(all.rows[1][3], "8") << "one kernel with four C and two ways of many classes";
  EXPECT_EQ(all.rows[1][5], "20.00 +- 0.00");
}

TEST(MaterialTables, ChooseByValidationAmongThoseOfTheSameTrainingSize) {
  const Findings findings = materialFindings(grid([](const MaterialClassifier& classifier) {
    const double best = classifier.samples == 3 ? 0.01 : 100;
    return classifier.kernel.gamma == best ? 0.9 : 0.5;
  }));
  EXPECT_EQ(tableOf(findings, "table_7_3").rows[1][0], "chi-squared gamma=0.01");
  const std::vector<std::string>& row = tableOf(findings, "table_7_samples").rows[1];
  EXPECT_EQ(row[3], "chi-squared gamma=100");
  EXPECT_EQ(row[11], "chi-squared gamma=0.01");
}

TEST(MaterialTables, CanBeOfClassifiersThatAreAllRejected) {
  const Findings findings = materialFindings(grid([](const MaterialClassifier&) { return 0.1; }));
  EXPECT_EQ(tableOf(findings, "table_7_6").rows[1][0], "rejected: below 30 %");
}

}  // namespace
}  // namespace place_recognition
