#include "evaluation/report.h"

#include <algorithm>

#include "base/text.h"
#include "evaluation/plots.h"
#include "evaluation/result_table.h"
#include "evaluation/timeline.h"
#include "report/html_page.h"
#include "report/svg.h"
#include "report/text_table.h"

namespace place_recognition {
namespace {

std::string figure(const std::string& value, const std::string& what) {
  return "<div><b>" + value + "</b>" + what + "</div>\n";
}

std::string titleAndFigures(const Evaluation& evaluation, const Summary& summary) {
  std::string html = "<h1>Model " + escapeMarkup(evaluation.model) + "</h1>\n<p>shown " +
                     std::to_string(evaluation.frames.size()) + " labelled images of";
  for (std::size_t r = 0; r < evaluation.recordings.size(); ++r) {
    html += (r == 0 ? " " : ", ") + escapeMarkup(evaluation.recordings[r]);
  }
  html += "</p>\n<div class=\"figures\">\n";
  html += figure(percent(summary.average_rate), "right, mean of the rooms");
  html += figure(percent(summary.unknown_share), "answered &lsquo;unknown&rsquo;");
  html += figure(fixed(summary.calibration_error, 3), "calibration error");
  html += figure(fixed(1000 * summary.latency_p50, 1) + " ms", "an image (median)");
  html += figure(fixed(1000 * summary.latency_p99, 1) + " ms", "an image (99 %)");
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

/// Rooms by runs, if there are several runs.
std::string runTable(const Summary& summary) {
  if (summary.recordings.size() < 2) return "";
  std::string html = "<h2>Rate by run</h2>\n<table>\n<thead><tr><th></th>";
  for (const RecordingSummary& recording : summary.recordings) {
    html += "<th>" + escapeMarkup(recording.condition) + "</th>";
  }
  html += "</tr></thead>\n";
  for (const RoomSummary& room : summary.rooms) {
    html +=
        "<tr><th>" + escapeMarkup(summary.places[static_cast<std::size_t>(room.place)]) + "</th>";
    for (const RecordingSummary& recording : summary.recordings)
      html += "<td>" + recording.rateText(room.place) + "</td>";
    html += "</tr>\n";
  }
  html += "<tr><th>mean of the rooms</th>";
  for (const RecordingSummary& recording : summary.recordings)
    html += "<td>" + rateText(recording.average_rate) + "</td>";
  return html +
         "</tr>\n</table>\n<p>Mean over the rooms of all runs: " + percent(summary.test_set_rate) +
         "</p>\n";
}

/// A cell of the confusion matrix; the larger its fraction of the row, the darker it is. The mouse
/// shows `what` it counts.
std::string confusionCell(std::uint64_t count, std::uint64_t row_sum, bool diagonal,
                          const std::string& what) {
  if (count == 0) return "<td></td>";
  const double fraction =
      row_sum == 0 ? 0 : static_cast<double>(count) / static_cast<double>(row_sum);
  const std::string colour = diagonal ? "59,110,165," : "192,80,77,";
  return "<td title=\"" + escapeMarkup(what) + "\" style=\"background:rgba(" + colour +
         fixed(0.75 * fraction, 3) + ")\">" + std::to_string(count) + "</td>";
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
    const std::string& truth = summary.places[row];
    for (std::size_t k = 0; k < places; ++k) {
      const std::string what = k == row ? truth : truth + ", answered " + summary.places[k];
      html += confusionCell(counts[k], sum, k == row, what);
    }
    html +=
        confusionCell(summary.confusion.none[row], sum, false, truth + ", no answer") + "</tr>\n";
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
  for (std::size_t r = 0; r < evaluation.recordings.size(); ++r) {
    html += "<p>" + escapeMarkup(evaluation.recordings[r]) + "</p>\n" +
            timelinePlot(evaluation, static_cast<int>(r));
  }
  return html;
}

std::string wrongImages(const Evaluation& evaluation) {
  if (evaluation.wrong.empty()) return "";
  std::string html = "<h2>Most confidently wrong</h2>\n<div class=\"row\">\n";
  for (const WrongImage& image : evaluation.wrong) {
    const FrameResult& frame = evaluation.frames[image.frame];
    html += htmlImage(
        image.jpeg, 280,
        escapeMarkup(evaluation.places[static_cast<std::size_t>(frame.truth)]) + ", taken for <b>" +
            escapeMarkup(evaluation.places[static_cast<std::size_t>(frame.place)]) + "</b> (" +
            percent(frame.confidence) + (frame.known ? "" : ", answered &lsquo;unknown&rsquo;") +
            ")<br>" + escapeMarkup(baseName(frame.name)));
  }
  return html + "</div>\n";
}

std::string captioned(const std::string& plot, const std::string& caption) {
  return "<figure>" + plot + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string confidenceSection(const Evaluation& evaluation, const Summary& summary) {
  return "<h2>Confidence</h2>\n<div class=\"row\">\n" +
         captioned(reliabilityPlot(summary),
                   "Reliability: on the diagonal, confidence says how often answers are right.") +
         captioned(confidencePlot(evaluation),
                   "Images by confidence, right (blue) and wrong (red).") +
         captioned(riskPlot(summary),
                   "Risk against coverage: wrong answers if only the most confident were given.") +
         "</div>\n" + htmlTable(reliabilityRows(summary)) + "<p>Expected calibration error " +
         fixed(summary.calibration_error, 3) + "; mean risk over coverage " +
         percent(meanRisk(summary.risk_coverage)) + ".</p>\n" + htmlTable(riskRows(summary));
}

std::string unknownSection(const Summary& summary) {
  if (!summary.unknown) return "";
  return "<h2>Known and unknown places</h2>\n" +
         captioned(rocPlot(*summary.unknown),
                   "Images of places never learned that are answered &lsquo;unknown&rsquo;, for "
                   "every threshold; the dot is the model&rsquo;s own. Area under the curve " +
                       fixed(summary.unknown->roc_area, 3) + ".");
}

}  // namespace

std::string htmlReport(const Evaluation& evaluation, const Summary& summary) {
  return htmlPage("Place recognition: evaluation",
                  titleAndFigures(evaluation, summary) + warningList(evaluation) +
                      "<h2>Rate of each room</h2>\n" + ratesPlot(summary) + runTable(summary) +
                      confusionTable(summary) + confidenceSection(evaluation, summary) +
                      unknownSection(summary) + timelines(evaluation) + wrongImages(evaluation));
}

}  // namespace place_recognition
