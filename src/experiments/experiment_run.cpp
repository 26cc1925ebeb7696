#include "experiments/experiment_run.h"

#include <optional>

#include "base/atomic_file.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

/// Incremented when the computation changes, so that cells of an older program are not reused.
constexpr int kVersion = 2;

/// According to RFC 4180: quoted if a cell contains a separator.
std::string csvCell(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string asCsv(const Table& table) {
  std::string text;
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : ",") + csvCell(row[i]);
    text += "\n";
  }
  return text;
}

std::string asText(const Findings& findings) {
  std::string text;
  for (const Table& table : findings.tables) {
    text += (text.empty() ? "" : "\n") + table.title + "\n\n" + alignColumns(table.rows);
  }
  return text;
}

void write(const Findings& findings, const std::string& text, const Json& results,
           const std::string& folder) {
  for (const Table& table : findings.tables) {
    writeFileAtomically(folder + "/" + table.name + ".csv", asCsv(table));
  }
  for (const Figure& figure : findings.figures) {
    writeFileAtomically(folder + "/" + figure.name + ".svg", figure.svg);
  }
  for (const Page& page : findings.pages) {
    writeFileAtomically(folder + "/" + page.name + ".html", page.html);
  }
  writeFileAtomically(folder + "/results.json", results.dump(1) + "\n");
  writeFileAtomically(folder + "/tables.txt", text);
}

/// The cells of an experiment on a data set, kept as files.
class Cells {
 public:
  Cells(Experiment& experiment, const std::string& folder, const std::string& data_digest)
      : experiment_(experiment),
        store_(folder),
        data_digest_(data_digest),
        cells_(experiment.cells()) {}

  std::size_t size() const { return cells_.size(); }
  const Json& operator[](std::size_t i) const { return cells_[i]; }

  /// Nothing if it is not computed yet.
  std::optional<Json> result(std::size_t i) const { return store_.find(keyOf(cells_[i])); }

  /// Computes the missing cells of one part; returns their number.
  std::size_t compute(const Part& part, const Progress& progress) {
    std::vector<Json> missing;
    for (std::size_t i = boundary(part.number - 1, part); i < boundary(part.number, part); ++i) {
      if (!result(i)) missing.push_back(cells_[i]);
    }
    std::size_t computed = 0;
    if (missing.empty()) return computed;
    experiment_.compute(
        missing,
        [&](const Json& cell, const Json& result) {
          store_.save(keyOf(cell), result);
          ++computed;
        },
        progress);
    return computed;
  }

 private:
  Json keyOf(const Json& cell) const {
    return {{"cell", cell}, {"data", data_digest_}, {"version", kVersion}};
  }

  std::size_t boundary(int parts_before, const Part& part) const {
    return cells_.size() * static_cast<std::size_t>(parts_before) /
           static_cast<std::size_t>(part.count);
  }

  Experiment& experiment_;
  const CellStore store_;
  const std::string data_digest_;
  const std::vector<Json> cells_;
};

}  // namespace

ExperimentOutcome runExperiment(Experiment& experiment, const std::string& folder,
                                const std::string& data_digest, const Part& part,
                                const Progress& progress) {
  Cells cells(experiment, folder + "/cells", data_digest);
  ExperimentOutcome outcome;
  outcome.cells = cells.size();
  outcome.computed = cells.compute(part, progress);
  std::vector<Json> results;
  Json record = Json::array();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::optional<Json> result = cells.result(i);
    if (!result) {
      ++outcome.missing;
      continue;
    }
    results.push_back(*result);
    record.push_back({{"cell", cells[i]}, {"result", *result}});
  }
  if (outcome.missing == 0) {
    const Findings findings = experiment.findings(results);
    outcome.text = asText(findings);
    write(findings, outcome.text, record, folder);
  }
  return outcome;
}

}  // namespace place_recognition
