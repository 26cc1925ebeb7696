#include "evaluation/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "evaluation/made_up_evaluation.h"
#include "evaluation/plots.h"
#include "evaluation/result_json.h"
#include "evaluation/result_table.h"
#include "evaluation/timeline.h"
#include "report/svg.h"

namespace place_recognition {
namespace {

TEST(ResultJson, HasTheKeysThatOtherProgramsRead) {
  const Evaluation evaluation = madeUpEvaluation();
  const nlohmann::json json = resultJson(evaluation, summarize(evaluation));
  EXPECT_DOUBLE_EQ(json.at("average_rate").get<double>(), 0.8);
  EXPECT_DOUBLE_EQ(json.at("rooms").at("kitchen").at("rate").get<double>(), 0.6);
  EXPECT_EQ(json.at("rooms").at("kitchen").at("count"), 5);
  EXPECT_EQ(json.at("confusion").at("labels"),
            (std::vector<std::string>{"kitchen", "office", "lift"}));
  EXPECT_EQ(json.at("confusion").at("counts").at(0).at(1), 1);
  EXPECT_TRUE(json.at("calibration_error").is_number());
  EXPECT_EQ(json.at("support_vectors"), 12);
  EXPECT_EQ(json.at("model_bytes"), 2048);
  EXPECT_EQ(json.at("confused").size(), 1u);
  EXPECT_EQ(json.at("confused").at(0).at("places"),
            (std::vector<std::string>{"kitchen", "office"}));
  EXPECT_DOUBLE_EQ(json.at("confused").at(0).at("rate").get<double>(), 1.0 / 6);
  EXPECT_DOUBLE_EQ(json.at("latency_ms").at("p50").get<double>(), 5);
  EXPECT_EQ(json.at("runs").at(1).at("condition"), "night");
  EXPECT_EQ(json.at("risk_coverage").size(), 10u);
  EXPECT_DOUBLE_EQ(json.at("risk_coverage").at(9).at("risk").get<double>(), 2.0 / 6);
  EXPECT_TRUE(json.at("latency_ms").contains("p95") && json.at("latency_ms").contains("p99"));
}

TEST(ResultTable, ShowsRoomsRunsAndConfusion) {
  const Evaluation evaluation = madeUpEvaluation();
  const std::string table = resultTable(evaluation, summarize(evaluation));
  EXPECT_EQ(table.substr(0, table.find("\n\n") + 1),
            "room               images    right  'unknown'      day   night\n"
            "kitchen                 5   60.0 %     40.0 %   66.7 %  50.0 %\n"
            "office                  1  100.0 %      0.0 %  100.0 %\n"
            "mean of the rooms           80.0 %              83.3 %  50.0 %\n");
  EXPECT_NE(table.find("A  kitchen                         3  1  .     1\n"), std::string::npos)
      << table;
  EXPECT_NE(table.find("kitchen, office                       16.7 %\n"), std::string::npos)
      << table;
}

/// Returns whether every opened element is closed, in order.
bool isWellFormed(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = html.find('<', at)) != std::string::npos;) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = html.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find(' ') - 0);
    const bool is_void = tag[0] == '!' || tag.back() == '/' || tag.compare(0, 4, "meta") == 0 ||
                         tag.compare(0, 3, "img") == 0 || tag == "br";
    if (tag[0] == '/') {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    } else if (!is_void) {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty();
}

TEST(ResultTable, OfManyPlacesAndRunsFitsATerminal) {
  Evaluation evaluation = madeUpEvaluation();
  for (int k = 3; k < 40; ++k) evaluation.places.push_back("room" + std::to_string(k));
  for (int r = 2; r < 20; ++r) evaluation.recordings.push_back("run" + std::to_string(r) + ".bag");
  const std::string table = resultTable(evaluation, summarize(evaluation));
  EXPECT_NE(table.find("confusion matrix of 40 places is in"), std::string::npos);
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST(Report, IsOneWellFormedPage) {
  Evaluation evaluation = madeUpEvaluation();
  evaluation.wrong.push_back({2, "jpeg"});
  const std::string html = htmlReport(evaluation, summarize(evaluation));
  EXPECT_TRUE(isWellFormed(html));
  EXPECT_NE(html.find("data:image/jpeg;base64,anBlZw=="), std::string::npos);
  EXPECT_EQ(html.find("http://"), html.find("http://www.w3.org/2000/svg"));
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(Report, NamesThePlacesOfACellOfTheConfusionMatrix) {
  const Evaluation evaluation = madeUpEvaluation();
  const std::string page = htmlReport(evaluation, summarize(evaluation));
  EXPECT_NE(page.find("title=\"kitchen, answered office\""), std::string::npos);
  EXPECT_NE(page.find("title=\"kitchen, no answer\""), std::string::npos);
}

TEST(PlaceColour, DiffersBetweenManyPlaces) {
  std::set<std::string> colours;
  for (std::size_t k = 0; k < 200; ++k) colours.insert(placeColour(k, 200));
  EXPECT_EQ(colours.size(), 200u);
  EXPECT_EQ(placeColour(1, 200), "hsl(137,55%,57%)");
  EXPECT_EQ(placeColour(1, 4), "hsl(90,55%,55%)");
}

TEST(Report, CountsImagesByConfidenceInLearnedPlacesOnly) {
  const std::string plot = confidencePlot(madeUpEvaluation());
  const auto images = [&plot](const std::string& kind) {
    int sum = 0;
    for (std::size_t at = 0; (at = plot.find(" " + kind, at)) != std::string::npos; ++at) {
      sum += plot[at - 1] - '0';
    }
    return sum;
  };
  EXPECT_EQ(images("right"), 4);
  EXPECT_EQ(images("wrong"), 2);  // not those of the lift, which the model has not learned
}

TEST(Report, ShowsUnknownPlacesIfAny) {
  Evaluation evaluation = madeUpEvaluation();
  const char* const kTitle = "Known and unknown places";
  EXPECT_NE(htmlReport(evaluation, summarize(evaluation)).find(kTitle), std::string::npos);
  evaluation.frames.resize(6);  // without the lift
  EXPECT_EQ(htmlReport(evaluation, summarize(evaluation)).find(kTitle), std::string::npos);
}

TEST(Timeline, ShowsAnswersOverTimeOfDrivesOnly) {
  Evaluation evaluation = madeUpEvaluation();
  evaluation.frames.clear();
  for (int i = 0; i < 100; ++i) {  // twenty seconds per room, in turn
    FrameResult frame;
    frame.stamp = i;
    frame.truth = frame.place_over_time = i / 20 % 2;
    frame.place = i % 7 == 0 ? 1 - frame.truth : frame.truth;
    frame.known = i % 7 != 0;
    evaluation.frames.push_back(frame);
  }
  const std::string drive = timelinePlot(evaluation, 0);
  EXPECT_TRUE(isWellFormed(drive));
  for (const char* text : {">truth<", ">single<", ">~place<", ">~smoothed<", "unknown (office)"}) {
    EXPECT_NE(drive.find(text), std::string::npos) << text;
  }
  std::stable_sort(evaluation.frames.begin(), evaluation.frames.end(),
                   [](const FrameResult& a, const FrameResult& b) { return a.truth < b.truth; });
  const std::string sorted = timelinePlot(evaluation, 0);
  EXPECT_EQ(sorted.find("~place"), std::string::npos);
  EXPECT_NE(sorted.find(">wrong<"), std::string::npos);
  EXPECT_EQ(timelinePlot(evaluation, 1), "");
}

TEST(Report, EscapesNames) {
  Evaluation evaluation = madeUpEvaluation();
  evaluation.places[0] = "<script>alert('x')</script>";
  evaluation.recordings[0] = "a&b\xff.bag";
  evaluation.warnings.push_back("<b>");
  const std::string html = htmlReport(evaluation, summarize(evaluation));
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;alert(&#39;x&#39;)"), std::string::npos);
  EXPECT_NE(html.find("a&amp;b?.bag"), std::string::npos);
  EXPECT_TRUE(isWellFormed(html));
}

TEST(Svg, EscapesWhatIsNotText) {
  EXPECT_EQ(escapeMarkup("K\xc3\xb6k & \"x\"\n"), "K\xc3\xb6k &amp; &quot;x&quot;?");
  EXPECT_EQ(escapeMarkup("\xff<"), "?&lt;");
}

}  // namespace
}  // namespace place_recognition
