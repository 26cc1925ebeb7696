#include <iomanip>
#include <iostream>
#include <memory>

#include "base/text.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recalibration.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct CalibrateOptions {
  std::vector<std::string> inputs;
  std::string model;
  std::string out;
  unsigned threads = 0;
  InputOptions input;
  OutputOptions output;
};

/// What a calibration fits.
struct Fitted {
  double slope, unknown_threshold;
  std::vector<double> cue_weights;
};

Fitted fittedOf(const Model& model) {
  return {model.calibration.slope, model.unknown_threshold, model.cue_weights};
}

Json json(const AnswerFigures& figures, const Fitted& fitted) {
  return {{"average_rate", figures.average_rate},
          {"calibration_error", figures.calibration_error},
          {"unknown", figures.unknown},
          {"slope", fitted.slope},
          {"unknown_threshold", fitted.unknown_threshold},
          {"cue_weights", fitted.cue_weights}};
}

void printRow(const std::string& what, int digits, double before, double after, std::ostream& out) {
  out << std::left << std::setw(28) << what << std::right << std::fixed << std::setprecision(digits)
      << std::setw(10) << before << std::setw(10) << after << "\n";
}

void printSummary(const Recalibration& result, const Fitted& before, std::ostream& out) {
  const Model& model = result.model;
  out << "Calibrated on " << result.images << " images, each judged without its own block of the "
      << "room:\n"
      << std::setw(38) << "before" << std::setw(10) << "after"
      << "\n";
  printRow("right, mean of the rooms, %", 1, 100 * result.before.average_rate,
           100 * result.after.average_rate, out);
  printRow("calibration error", 3, result.before.calibration_error, result.after.calibration_error,
           out);
  printRow("answered 'unknown', %", 1, 100 * result.before.unknown, 100 * result.after.unknown,
           out);
  printRow("slope", 3, before.slope, model.calibration.slope, out);
  printRow("unknown below", 3, before.unknown_threshold, model.unknown_threshold, out);
  for (std::size_t c = 0; c < model.cue_weights.size(); ++c) {
    printRow("weight of " + model.options.cues[c].name, 2, before.cue_weights[c],
             model.cue_weights[c], out);
  }
  out << "The answer 'unknown' is set for " << percent(model.options.unknown.false_alarm_rate)
      << " of these images; in light that is easier to recognize it is rarer.\n";
}

void calibrateModel(const CalibrateOptions& options) {
  const std::string path = modelPath(options.out.empty() ? options.model : options.out);
  requireWritable(path, Contents::kModel);
  Model model = loadModel(modelPath(options.model));
  const Fitted before = fittedOf(model);
  const std::vector<RecordingOpener> recordings = options.input.openers(options.inputs);

  ProgressDisplay display(options.output.progress);
  const Recalibration result =
      recalibrate(std::move(model), recordings, options.threads, display.callback());
  saveModel(result.model, path);
  display.clear();

  printWarnings(result.warnings);
  printSummary(result, before, options.output.text());
  options.output.text() << "Model: " << path << std::endl;
  options.output.writeJson({{"images", result.images},
                            {"before", json(result.before, before)},
                            {"after", json(result.after, fittedOf(result.model))},
                            {"model", path},
                            {"warnings", result.warnings}});
}

}  // namespace

void addCalibrate(CommandLine& tool) {
  Verb& verb = tool.verb("calibrate", "Fits a model's confidence and 'unknown' to another run");
  const auto options = std::make_shared<CalibrateOptions>();
  verb.argument("INPUT", options->inputs, kInputHelp);
  verb.option("--model", "NAME", options->model, "Name or file of the model; its file is replaced")
      .required();
  verb.option("--out", "NAME2", options->out,
              "Name or file of the result, if the model is to be kept");
  options->input.addTo(verb);
  addThreads(verb, options->threads);
  options->output.addTo(verb);
  verb.footer(
      "Fits the weights of the cues, the slope of the probabilities and the threshold of "
      "'unknown'\n"
      "to labelled runs that the model was not trained on. The learned rooms do not change.\n"
      "Example:\n"
      "  place_tool calibrate --model office thursday.bag");
  verb.run([options] { calibrateModel(*options); });
}

}  // namespace place_recognition::tool
