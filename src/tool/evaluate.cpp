#include <filesystem>
#include <iostream>
#include <memory>

#include "evaluation/evaluation.h"
#include "evaluation/report.h"
#include "evaluation/result_json.h"
#include "evaluation/result_table.h"
#include "place_recognition/model_file.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct EvaluateOptions {
  std::vector<std::string> inputs;
  std::string model;
  std::string adjacency;
  std::string report;
  InputOptions input;
  OutputOptions output;
};

std::shared_ptr<const Model> modelOf(const EvaluateOptions& options) {
  Model model = loadModel(modelPath(options.model));
  if (!options.adjacency.empty()) {
    model.adjacency = readAdjacency(options.adjacency, model.places);
  }
  return std::make_shared<const Model>(std::move(model));
}

void evaluateModel(const EvaluateOptions& options) {
  const std::string report = options.report + "/report.html";
  if (!options.report.empty()) requireWritable(report, Contents::kText);
  const std::shared_ptr<const Model> model = modelOf(options);
  const std::uint64_t model_bytes = std::filesystem::file_size(modelPath(options.model));
  const std::vector<RecordingOpener> recordings = options.input.openers(options.inputs);

  ProgressDisplay display(options.output.progress);
  constexpr std::size_t kWrongImages = 24;  // in the report
  Evaluation evaluation = evaluate(model, recordings, kWrongImages, display.callback());
  evaluation.model_bytes = model_bytes;
  const Summary summary = summarize(evaluation);
  display.clear();

  printWarnings(evaluation.warnings);
  options.output.text() << resultTable(evaluation, summary) << std::flush;
  if (!options.report.empty()) {
    writeText(report, htmlReport(evaluation, summary));
    options.output.text() << "Report: " << report << std::endl;
  }
  options.output.writeJson(Json(resultJson(evaluation, summary)));
}

}  // namespace

void addEvaluate(CommandLine& tool) {
  Verb& verb = tool.verb("evaluate", "Measures how well a model recognizes labelled runs");
  const auto options = std::make_shared<EvaluateOptions>();
  verb.argument("INPUT", options->inputs, kInputHelp);
  verb.option("--model", "NAME", options->model, "Name or file of the model").required();
  verb.option("--adjacency", "FILE", options->adjacency,
              "YAML file that lists which rooms adjoin, rooms: {kitchen: [corridor], ...}, as the "
              "node's ~adjacency; left out: as learned by the model");
  verb.option("--report", "DIR", options->report,
              "Write DIR/report.html with metrics, plots and the images of the worst errors");
  options->input.addTo(verb);
  options->output.addTo(verb);
  verb.footer(
      "Prints the rate of each room and their unweighted mean, the confusion matrix, the\n"
      "calibration of the confidence, and the time per image. Images of places that the model has\n"
      "not learned measure how reliably it answers 'unknown'.\n"
      "Example:\n"
      "  place_tool evaluate --model office wednesday.bag --report report");
  verb.run([options] { evaluateModel(*options); });
}

}  // namespace place_recognition::tool
