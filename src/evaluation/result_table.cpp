#include "evaluation/result_table.h"

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

// What a terminal can show; the report shows all.
constexpr std::size_t kMostPlaces = 30;  // in the confusion matrix
constexpr std::size_t kMostRuns = 8;     // with a column each

std::string ratesTable(const Summary& summary) {
  const bool several = summary.recordings.size() > 1 && summary.recordings.size() <= kMostRuns;
  TextRows rows{{"room", "images", "right", "'unknown'"}};
  if (several) {
    for (const RecordingSummary& recording : summary.recordings)
      rows[0].push_back(recording.condition);
  }
  for (const RoomSummary& room : summary.rooms) {
    rows.push_back({summary.places[static_cast<std::size_t>(room.place)],
                    std::to_string(room.count), percent(room.rate()),
                    percent(room.unknownFraction())});
    if (!several) continue;
    for (const RecordingSummary& recording : summary.recordings)
      rows.back().push_back(recording.rateText(room.place));
  }
  rows.push_back({"mean of the rooms", "", percent(summary.average_rate), ""});
  if (several) {
    for (const RecordingSummary& recording : summary.recordings)
      rows.back().push_back(rateText(recording.average_rate));
  }
  return alignColumns(rows);
}

/// Empty unless there are several cameras.
std::string camerasTable(const Summary& summary) {
  if (summary.cameras.empty()) return "";
  TextRows rows{{"camera", "images", "mean of the rooms"}};
  for (const CameraSummary& camera : summary.cameras) {
    rows.push_back({camera.name, std::to_string(camera.count), rateText(camera.average_rate)});
  }
  return alignColumns(rows) + "\n";
}

std::string confusionTable(const Summary& summary) {
  if (summary.places.size() > kMostPlaces) {
    return "The confusion matrix of " + std::to_string(summary.places.size()) +
           " places is in the outputs of --report and --json.\n";
  }
  const Confusion& confusion = summary.confusion;
  const bool some_none = std::any_of(confusion.none.begin(), confusion.none.end(),
                                     [](std::uint64_t count) { return count > 0; });
  TextRows rows{{"true place (row), answer (column)"}};
  for (std::size_t k = 0; k < summary.places.size(); ++k) rows[0].push_back(columnName(k));
  if (some_none) rows[0].push_back("none");
  for (std::size_t k = 0; k < summary.places.size(); ++k) {
    rows.push_back({columnName(k) + "  " + summary.places[k]});
    for (const std::uint64_t count : confusion.counts[k]) {
      rows.back().push_back(count == 0 ? "." : std::to_string(count));
    }
    if (some_none) rows.back().push_back(std::to_string(confusion.none[k]));
  }
  return alignColumns(rows);
}

/// The most confused pairs of places; empty if there are none.
std::string confusedTable(const Summary& summary) {
  const std::size_t most = summary.places.size() > kMostPlaces ? 20 : 5;
  if (summary.confused.empty()) return "";
  TextRows rows{{"taken for one another", "of the images of both"}};
  for (const ConfusedPair& pair : summary.confused) {
    if (rows.size() > most) break;
    rows.push_back({summary.places[static_cast<std::size_t>(pair.a)] + ", " +
                        summary.places[static_cast<std::size_t>(pair.b)],
                    percent(pair.rate)});
  }
  return alignColumns(rows) + "\n";
}

std::string otherFigures(const Evaluation& evaluation, const Summary& summary) {
  TextRows rows;
  if (summary.recordings.size() > 1) {
    rows.push_back({"mean over the rooms of all runs", percent(summary.test_set_rate)});
  }
  rows.push_back({"calibration error", fixed(summary.calibration_error, 3)});
  rows.push_back({"mean risk over coverage", percent(meanRisk(summary.risk_coverage))});
  rows.push_back({"answered 'unknown'", percent(summary.unknown_share)});
  if (summary.unknown) {
    rows.push_back(
        {"answered 'unknown' in places never learned", percent(summary.unknown->detection_rate)});
    rows.push_back({"known against unknown, area under ROC", fixed(summary.unknown->roc_area, 3)});
  }
  rows.push_back({"support vectors", std::to_string(evaluation.support_vectors)});
  rows.push_back({"model", fixed(static_cast<double>(evaluation.model_bytes) / 1024, 0) + " KiB"});
  rows.push_back({"latency, median", fixed(1000 * summary.latency_p50, 1) + " ms"});
  rows.push_back({"latency, 95 %", fixed(1000 * summary.latency_p95, 1) + " ms"});
  rows.push_back({"latency, 99 %", fixed(1000 * summary.latency_p99, 1) + " ms"});
  return alignColumns(rows);
}

/// Empty if no run is a drive.
std::string overTimeTable(const Summary& summary) {
  if (!summary.over_time) return "";
  const OverTime& over_time = *summary.over_time;
  TextRows rows;
  const auto add = [&](const std::string& which, const AnswersOverTime& answers) {
    const auto row = [&](const std::string& name, const AnswerCounts& counts) {
      rows.push_back({name, std::to_string(counts.wrong), std::to_string(counts.unknown)});
    };
    const std::string title = which + ", " + counted(answers.frames, "frame");
    rows.push_back({title, rows.empty() ? "wrong room" : "", rows.empty() ? "'unknown'" : ""});
    row("frame by frame", answers.single);
    row("over time, as ~place", answers.filtered);
    row("with a second to come, as ~smoothed", answers.smoothed);
  };
  add("drives", over_time.all);
  add("not within 1 s before or 2 s after a change of room", over_time.settled);
  return alignColumns(rows) + "changes of room followed within 2 s: " +
         percent(over_time.followedWithin(OverTime::kAfter)) + " of " +
         std::to_string(over_time.delays.size() + over_time.missed) + "\n\n";
}

}  // namespace

TextRows reliabilityRows(const Summary& summary) {
  TextRows rows{{"confidence", "images", "mean confidence", "right"}};
  for (std::size_t i = 0; i < summary.reliability.size(); ++i) {
    const ReliabilityBin& bin = summary.reliability[i];
    if (bin.count == 0) continue;
    rows.push_back({std::to_string(10 * i) + " to " + std::to_string(10 * (i + 1)) + " %",
                    std::to_string(bin.count), percent(bin.confidence), percent(bin.rate)});
  }
  return rows;
}

TextRows riskRows(const Summary& summary) {
  TextRows rows{{"most confident answers given"}, {"wrong among them"}};
  for (const int fraction : {20, 40, 60, 80, 90, 100}) {
    rows[0].push_back(std::to_string(fraction) + " %");
    rows[1].push_back(percent(riskAt(summary.risk_coverage, fraction / 100.0)));
  }
  return rows;
}

std::string resultTable(const Evaluation& evaluation, const Summary& summary) {
  return ratesTable(summary) + "\n" + camerasTable(summary) + confusionTable(summary) + "\n" +
         confusedTable(summary) + alignColumns(reliabilityRows(summary)) + "\n" +
         alignColumns(riskRows(summary)) + "\n" + overTimeTable(summary) +
         otherFigures(evaluation, summary);
}

}  // namespace place_recognition
