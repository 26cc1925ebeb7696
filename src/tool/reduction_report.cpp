#include "tool/reduction_report.h"

#include <cstdio>

#include "base/text.h"
#include "report/fraction_plot.h"
#include "report/html_page.h"
#include "report/svg.h"
#include "report/text_table.h"

namespace place_recognition::tool {
namespace {

std::string scientific(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1e", number);
  return text;
}

TextRows tableRows(const ReductionReport& report) {
  TextRows rows{{"method", "vectors", "of all", "largest change", "mean change", "rate", "kept",
                 "KiB", "ms per frame"}};
  const ReductionFigures& before = report.before;
  const auto add = [&](const ReductionFigures& figures) {
    const double all = static_cast<double>(std::max<std::size_t>(1, before.support_vectors));
    const bool rated = figures.rate && *before.rate > 0;
    rows.push_back({figures.method, std::to_string(figures.support_vectors),
                    percent(static_cast<double>(figures.support_vectors) / all),
                    scientific(figures.change.largest), scientific(figures.change.mean),
                    figures.rate ? percent(*figures.rate) : "",
                    rated ? percent(*figures.rate / *before.rate) : "",
                    fixed(static_cast<double>(figures.model_bytes) / 1024, 1),
                    fixed(figures.comparison_ms, 3)});
  };
  add(before);
  for (const ReductionFigures& figures : report.methods) add(figures);
  return rows;
}

std::string notes(const ReductionReport& report) {
  return "Changes are those of the machines' decision values on " + report.values_of +
         ". The time per frame is that of comparing it with the support vectors, without "
         "extracting its features.";
}

Json figuresJson(const ReductionFigures& figures) {
  Json json = {{"support_vectors", figures.support_vectors},
               {"max_margin_change", figures.change.largest},
               {"mean_margin_change", figures.change.mean},
               {"model_bytes", figures.model_bytes},
               {"comparison_ms", figures.comparison_ms}};
  if (figures.rate) json["average_rate"] = *figures.rate;
  if (!figures.curve.empty()) json["curve"] = figures.curve;
  return json;
}

}  // namespace

std::string reductionTable(const ReductionReport& report) {
  return alignColumns(tableRows(report)) + notes(report) + "\n";
}

Json reductionJson(const ReductionReport& report) {
  const ReductionFigures& after = report.methods.front();
  Json json = {{"support_vectors_before", report.before.support_vectors},
               {"support_vectors_after", after.support_vectors},
               {"max_margin_change", after.change.largest},
               {"mean_margin_change", after.change.mean},
               {"margins_of", report.values_of},
               {"model_bytes", after.model_bytes},
               {"comparison_ms", after.comparison_ms},
               {"model", report.model},
               {"before", figuresJson(report.before)},
               {"methods", Json::object()},
               {"warnings", report.warnings}};
  for (const ReductionFigures& figures : report.methods) {
    json["methods"][figures.method] = figuresJson(figures);
  }
  if (after.rate) {
    json["validation"] = {{"average_rate_before", *report.before.rate},
                          {"average_rate_after", *after.rate}};
  }
  return json;
}

std::string reductionPage(const ReductionReport& report) {
  std::string body = "<h1>Reduction of support vectors</h1>\n<p>" + escapeMarkup(report.model) +
                     "</p>\n" + htmlTable(tableRows(report)) + "<p>" + escapeMarkup(notes(report)) +
                     "</p>\n";
  std::vector<Curve> curves;
  for (const ReductionFigures& figures : report.methods) {
    if (!figures.curve.empty()) curves.push_back({figures.method, figures.curve});
  }
  if (!curves.empty()) {
    body += "<h2>Rate on the validation runs against the vectors kept</h2>\n" +
            fractionsPlot("support vectors", "rate, mean of the rooms", curves);
  }
  return htmlPage("Place recognition: reduction", body);
}

}  // namespace place_recognition::tool
