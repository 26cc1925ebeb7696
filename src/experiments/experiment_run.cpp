#include "experiments/experiment_run.h"

#include <map>

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

}  // namespace

ExperimentOutcome runExperiment(Experiment& experiment, const std::string& folder,
                                const std::string& data_digest, const Part& part,
                                const Progress& progress) {
  const CellStore store(folder + "/cells");
  const auto keyOf = [&](const Json& cell) {
    return Json{{"cell", cell}, {"data", data_digest}, {"version", kVersion}};
  };
  const std::vector<Json> cells = experiment.cells();
  const auto boundary = [&](int parts_before) {
    return cells.size() * static_cast<std::size_t>(parts_before) /
           static_cast<std::size_t>(part.count);
  };

  ExperimentOutcome outcome;
  outcome.cells = cells.size();
  std::vector<Json> wanted;
  for (std::size_t i = boundary(part.number - 1); i < boundary(part.number); ++i) {
    if (!store.find(keyOf(cells[i]))) wanted.push_back(cells[i]);
  }
  if (!wanted.empty()) {
    experiment.compute(
        wanted,
        [&](const Json& cell, const Json& result) {
          store.save(keyOf(cell), result);
          ++outcome.computed;
        },
        progress);
  }

  std::vector<Json> results;
  Json record = Json::array();
  for (const Json& cell : cells) {
    const auto result = store.find(keyOf(cell));
    if (!result) {
      ++outcome.missing;
      continue;
    }
    results.push_back(*result);
    record.push_back({{"cell", cell}, {"result", *result}});
  }
  if (outcome.missing == 0) {
    const Findings findings = experiment.findings(results);
    outcome.text = asText(findings);
    write(findings, outcome.text, record, folder);
  }
  return outcome;
}

}  // namespace place_recognition
