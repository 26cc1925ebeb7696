#include "evaluation/report.h"

#include <algorithm>
#include <cstdint>

#include "evaluation/plots.h"
#include "evaluation/svg.h"
#include "evaluation/text_table.h"

namespace place_recognition {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>Place recognition: evaluation</title>
<style>
body { font: 15px/1.5 sans-serif; color: #333; max-width: 920px; margin: 2em auto; padding: 0 1em }
h1 { font-size: 1.6em; margin-bottom: 0 }
h2 { font-size: 1.2em; margin: 2em 0 0.5em; border-bottom: 1px solid #ddd }
table { border-collapse: collapse }
th, td { padding: 3px 10px; text-align: right; font-weight: normal }
th:first-child { text-align: left }
td { font-variant-numeric: tabular-nums }
thead th { border-bottom: 1px solid #999; color: #666 }
.figures { display: flex; flex-wrap: wrap; gap: 1em 3em; margin: 1em 0 }
.figures b { display: block; font-size: 1.8em; font-weight: normal; color: #3b6ea5 }
.row { display: flex; flex-wrap: wrap; gap: 1em }
figure { margin: 0 }
figcaption { font-size: 0.85em; color: #666; max-width: 320px }
.legend span { display: inline-block; margin-right: 1.2em }
.legend i { display: inline-block; width: 0.9em; height: 0.9em; margin-right: 0.4em }
svg { max-width: 100% }
</style>
</head>
<body>
)";

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string figure(const std::string& value, const std::string& what) {
  return "<div><b>" + value + "</b>" + what + "</div>\n";
}

std::string titleAndFigures(const Evaluation& evaluation, const Summary& summary) {
  std::string html = "<h1>Model " + escapeMarkup(evaluation.model) + "</h1>\n<p>shown " +
                     std::to_string(evaluation.frames.size()) + " labelled pictures of";
  for (std::size_t r = 0; r < evaluation.runs.size(); ++r) {
    html += (r == 0 ? " " : ", ") + escapeMarkup(evaluation.runs[r]);
  }
  html += "</p>\n<div class=\"figures\">\n";
  html += figure(percent(summary.average_rate), "right, mean of the rooms");
  html += figure(percent(summary.unknown_share), "answered &lsquo;unknown&rsquo;");
  html += figure(fixed(summary.calibration_error, 3), "calibration error");
  html += figure(fixed(1000 * summary.latency_p50, 1) + " ms", "a picture (median)");
  html += figure(fixed(1000 * summary.latency_p99, 1) + " ms", "a picture (99 %)");
  html += figure(std::to_string(evaluation.support_vectors), "support vectors");
  if (summary.unknown) {
    html += figure(fixed(summary.unknown->roc_area, 3), "known against unknown, area under ROC");
  }
  return html + "</div>\n";
}

std::string warningList(const Evaluation& evaluation) {
  if (evaluation.warnings.empty()) return "";
  std::string html = "<ul>\n";
  for (const std::string& warning : evaluation.warnings) {
    html += "<li>" + escapeMarkup(warning) + "</li>\n";
  }
  return html + "</ul>\n";
}

/// The rate of a room in one run; empty if the run does not show it.
std::string rateIn(const RunSummary& run, int place) {
  const auto found = std::find_if(run.rooms.begin(), run.rooms.end(),
                                  [place](const RoomSummary& room) { return room.place == place; });
  return found == run.rooms.end() ? "" : percent(found->rate());
}

/// Rooms by runs, for more than one run.
std::string runTable(const Summary& summary) {
  if (summary.runs.size() < 2) return "";
  std::string html = "<h2>Rate by run</h2>\n<table>\n<thead><tr><th></th>";
  for (const RunSummary& run : summary.runs) {
    html += "<th>" + escapeMarkup(baseName(run.name)) + "</th>";
  }
  html += "</tr></thead>\n";
  for (const RoomSummary& room : summary.rooms) {
    html +=
        "<tr><th>" + escapeMarkup(summary.places[static_cast<std::size_t>(room.place)]) + "</th>";
    for (const RunSummary& run : summary.runs) html += "<td>" + rateIn(run, room.place) + "</td>";
    html += "</tr>\n";
  }
  html += "<tr><th>mean of the rooms</th>";
  for (const RunSummary& run : summary.runs) html += "<td>" + percent(run.average_rate) + "</td>";
  return html +
         "</tr>\n</table>\n<p>Mean over the rooms of all runs: " + percent(summary.test_set_rate) +
         "</p>\n";
}

/// A cell of the confusion matrix, the darker the larger its share of the row.
std::string confusionCell(std::uint64_t count, std::uint64_t row_sum, bool diagonal) {
  const double share = row_sum == 0 ? 0 : static_cast<double>(count) / static_cast<double>(row_sum);
  const std::string colour = diagonal ? "59,110,165," : "192,80,77,";
  return "<td style=\"background:rgba(" + colour + fixed(0.75 * share, 3) + ")\">" +
         (count == 0 ? "" : std::to_string(count)) + "</td>";
}

std::string confusionTable(const Summary& summary) {
  std::string html =
      "<h2>Confusion matrix</h2>\n<p>Rows: the true place; columns: the most probable one.</p>\n"
      "<table>\n<thead><tr><th></th>";
  const std::size_t places = summary.places.size();
  for (std::size_t k = 0; k < places; ++k) html += "<th>" + columnName(k) + "</th>";
  html += "<th>none</th></tr></thead>\n";
  for (std::size_t row = 0; row < places; ++row) {
    const std::vector<std::uint64_t>& counts = summary.confusion.counts[row];
    std::uint64_t sum = summary.confusion.none[row];
    for (const std::uint64_t count : counts) sum += count;
    html += "<tr><th>" + columnName(row) + "&ensp;" + escapeMarkup(summary.places[row]) + "</th>";
    for (std::size_t k = 0; k < places; ++k) html += confusionCell(counts[k], sum, k == row);
    html += confusionCell(summary.confusion.none[row], sum, false) + "</tr>\n";
  }
  return html + "</table>\n";
}

std::string timelines(const Evaluation& evaluation) {
  const std::size_t places = evaluation.places.size();
  std::string html = "<h2>Truth and answer over time</h2>\n<p class=\"legend\">";
  for (std::size_t k = 0; k < places; ++k) {
    html += "<span><i style=\"background:" + placeColour(k, places) + "\"></i>" +
            escapeMarkup(evaluation.places[k]) + "</span>";
  }
  html += "<span><i style=\"background:#eee\"></i>unknown</span></p>\n";
  for (std::size_t r = 0; r < evaluation.runs.size(); ++r) {
    html += "<p>" + escapeMarkup(evaluation.runs[r]) + "</p>\n" +
            timelinePlot(evaluation, static_cast<int>(r));
  }
  return html;
}

std::string wrongPictures(const Evaluation& evaluation) {
  if (evaluation.wrong.empty()) return "";
  std::string html = "<h2>Most confidently wrong</h2>\n<div class=\"row\">\n";
  for (const WrongPicture& picture : evaluation.wrong) {
    const FrameResult& frame = evaluation.frames[picture.frame];
    html += "<figure><img width=\"280\" alt=\"\" src=\"data:image/jpeg;base64," +
            base64(picture.jpeg) + "\"><figcaption>" +
            escapeMarkup(evaluation.places[static_cast<std::size_t>(frame.truth)]) +
            ", taken for <b>" +
            escapeMarkup(evaluation.places[static_cast<std::size_t>(frame.place)]) + "</b> (" +
            percent(frame.confidence) + (frame.known ? "" : ", answered &lsquo;unknown&rsquo;") +
            ")<br>" + escapeMarkup(baseName(frame.name)) + "</figcaption></figure>\n";
  }
  return html + "</div>\n";
}

}  // namespace

std::string htmlReport(const Evaluation& evaluation, const Summary& summary) {
  return kHead + titleAndFigures(evaluation, summary) + warningList(evaluation) +
         "<h2>Rate of each room</h2>\n" + ratesPlot(summary) + runTable(summary) +
         confusionTable(summary) + "<h2>Confidence</h2>\n<div class=\"row\">\n<figure>" +
         reliabilityPlot(summary) +
         "<figcaption>Reliability: on the diagonal, confidence says how often answers are right."
         "</figcaption></figure>\n<figure>" +
         confidencePlot(evaluation) +
         "<figcaption>Pictures by confidence, right (blue) and wrong (red).</figcaption></figure>\n"
         "<figure>" +
         riskPlot(summary) +
         "<figcaption>Risk against coverage: wrong answers if only the most confident were given."
         "</figcaption></figure>\n</div>\n" +
         timelines(evaluation) + wrongPictures(evaluation) + "</body>\n</html>\n";
}

}  // namespace place_recognition
