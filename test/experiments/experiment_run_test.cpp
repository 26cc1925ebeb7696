#include "experiments/experiment_run.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

/// Computes the squares of 0..9; stops after `patience` of them.
class Squares : public Experiment {
 public:
  explicit Squares(std::size_t patience = 100) : patience_(patience) {}

  std::vector<Json> cells() const override {
    std::vector<Json> cells;
    for (int i = 0; i < 10; ++i) cells.push_back({{"number", i}});
    return cells;
  }
  void compute(const std::vector<Json>& cells, const CellSink& finished,
               const Progress& /*progress*/) override {
    for (const Json& cell : cells) {
      if (patience_-- == 0) throw Cancelled();
      const int number = cell.at("number");
      finished(cell, number * number);
    }
  }
  Findings findings(const std::vector<Json>& results) const override {
    Table table{"squares", "Squares", {{"number", "square, \"exactly\""}}};
    for (std::size_t i = 0; i < results.size(); ++i) {
      table.rows.push_back({std::to_string(i), results[i].dump()});
    }
    return {{table}, {{"curve", "<svg/>"}}};
  }

 private:
  std::size_t patience_;
};

std::string contents(const std::string& path) { return readFile(path, 1 << 20); }

TEST(RunExperiment, ResumesWhereItWasStopped) {
  const ScratchFolder folder;
  Squares impatient(4);
  EXPECT_THROW(runExperiment(impatient, folder / "out", "1", {}, {}), Cancelled);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/tables.txt"));
  Squares squares;
  EXPECT_EQ(runExperiment(squares, folder / "out", "1", {}, {}).computed, 6u);
  EXPECT_EQ(runExperiment(squares, folder / "out", "1", {}, {}).computed, 0u);
}

TEST(RunExperiment, OtherDataIsAnotherCell) {
  const ScratchFolder folder;
  Squares squares;
  runExperiment(squares, folder / "out", "1", {}, {});
  EXPECT_EQ(runExperiment(squares, folder / "out", "2", {}, {}).computed, 10u);
}

TEST(RunExperiment, PartsMakeUpTheWhole) {
  const ScratchFolder whole, parts;
  Squares squares;
  runExperiment(squares, whole / "out", "1", {}, {});
  std::size_t computed = 0;
  for (int part = 3; part >= 1; --part) {
    const ExperimentOutcome outcome = runExperiment(squares, parts / "out", "1", {part, 3}, {});
    computed += outcome.computed;
    EXPECT_EQ(outcome.missing, 10 - computed);
    EXPECT_EQ(outcome.text.empty(), part > 1);
  }
  EXPECT_EQ(computed, 10u);
  for (const char* file :
       {"out/tables.txt", "out/squares.csv", "out/curve.svg", "out/results.json"}) {
    EXPECT_EQ(contents(parts / file), contents(whole / file)) << file;
  }
}

TEST(RunExperiment, CsvQuotesWhatNeedsIt) {
  const ScratchFolder folder;
  Squares squares;
  runExperiment(squares, folder / "out", "1", {}, {});
  EXPECT_EQ(contents(folder / "out/squares.csv").substr(0, 37),
            "number,\"square, \"\"exactly\"\"\"\n0,0\n1,1\n");
}

}  // namespace
}  // namespace place_recognition
