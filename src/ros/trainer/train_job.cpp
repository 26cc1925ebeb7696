#include "ros/trainer/train_job.h"

#include <boost/algorithm/string/replace.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/child_process.h"
#include "base/temporary_file.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "ros/trainer/train_command.h"

namespace place_recognition {
namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

/// Interval at which run() checks whether to stop.
constexpr std::chrono::milliseconds kPoll(100);
/// Time for place_tool to clean up after an interrupt before it is killed.
constexpr std::chrono::seconds kPatience(8);
/// Maximum size of the warnings repeated in a message.
constexpr std::size_t kMaxWarningBytes = 2000;

/// The file of the configuration in a goal; null if the goal has none.
std::unique_ptr<TemporaryFile> temporaryYaml(const std::string& text) {
  if (text.empty()) return nullptr;
  const std::string folder = std::filesystem::temp_directory_path().string();
  auto file = std::make_unique<TemporaryFile>(folder + "/place_recognition_", ".yaml",
                                              "a temporary file in " + folder);
  file->write(text);
  return file;
}

TrainFeedback toFeedback(const Json& line) {
  TrainFeedback feedback;
  feedback.stage = line.at("stage").get<std::string>();
  feedback.fraction = line.at("fraction").get<double>();
  feedback.message = feedback.stage + ", " + percent(feedback.fraction, 0);
  return feedback;
}

/// "calibration error 0.120, then 0.041": a figure before and after.
std::string change(const std::string& what, const Json& figures, const char* key) {
  return what + " " + fixed(figures.at("before").at(key).get<double>(), 3) + ", then " +
         fixed(figures.at("after").at(key).get<double>(), 3);
}

TrainResult calibrationResult(const Json& figures, const std::string& model) {
  TrainResult result;
  result.success = true;
  result.images = figures.at("images").get<std::uint64_t>();
  result.validation_rate = figures.at("after").at("average_rate").get<double>();
  result.message = "Calibrated " + model + " on " + std::to_string(result.images) +
                   " images: " + change("rate", figures, "average_rate") + "; " +
                   change("calibration error", figures, "calibration_error") + "; " +
                   change("'unknown'", figures, "unknown") + "; " +
                   change("slope", figures, "slope") + "; " +
                   change("'unknown' below", figures, "unknown_threshold") + ".";
  return result;
}

TrainResult toResult(const Json& figures, const std::string& model) {
  if (figures.contains("before")) return calibrationResult(figures, model);
  TrainResult result;
  result.success = true;
  result.images = figures.at("images").get<std::uint64_t>();
  for (const auto& [place, details] : figures.at("rooms").items()) result.places.push_back(place);
  result.support_vectors = figures.at("support_vectors").get<std::uint64_t>();
  result.validation_rate = figures.at("validation").at("average_rate").get<double>();
  result.seconds = figures.at("seconds").get<double>();
  result.message = "Learned " + std::to_string(result.places.size()) + " places from " +
                   std::to_string(result.images) + " images as " + model + ": " +
                   percent(result.validation_rate, 0) + " right on held-out blocks";
  if (figures.contains("validate_rate")) {
    result.message += ", " + percent(figures.at("validate_rate").get<double>(), 0) + " on validate";
  }
  result.message += ".";
  return result;
}

/// An error of place_tool without the reference to its help, which has no options of a goal.
std::string withoutHelp(const std::string& line) {
  return endsWith(line, " --help.") ? line.substr(0, line.rfind("; see ")) + "." : line;
}

TrainResult failure(const std::string& message) {
  TrainResult result;
  result.success = false;
  result.message = message;
  return result;
}

/// Interprets the lines of place_tool.
class ToolOutput {
 public:
  ToolOutput(const std::string& model, const TrainJob::FeedbackCallback& on_feedback,
             const TrainJob::WarningCallback& on_warning)
      : model_(model), on_feedback_(on_feedback), on_warning_(on_warning) {}

  void onOutput(const std::string& line) {
    try {
      const Json object = Json::parse(line);
      if (object.contains("stage")) {
        on_feedback_(toFeedback(object));
      } else {
        result_ = toResult(object, model_);
      }
    } catch (const Json::exception& e) {
      last_error_ = "place_tool printed an invalid line: " + std::string(e.what());
    }
  }

  void onError(const std::string& line) {
    for (const std::string start : {"warning: ", "note: "}) {
      if (!startsWith(line, start)) continue;
      const std::string sentence = inTermsOfGoal(line.substr(start.size()));
      on_warning_(sentence);
      if (warnings_.size() < kMaxWarningBytes) warnings_ += " " + sentence;
      return;
    }
    if (!line.empty()) last_error_ = inTermsOfGoal(withoutHelp(line));
  }

  TrainResult result(int exit_status) const {
    if (exit_status == 0 && result_) {
      TrainResult result = *result_;
      result.message += warnings_;
      return result;
    }
    return failure((last_error_.empty() ? "Training ended with " + describeExit(exit_status) + "."
                                        : last_error_) +
                   warnings_);
  }

 private:
  std::string model_;
  const TrainJob::FeedbackCallback& on_feedback_;
  const TrainJob::WarningCallback& on_warning_;
  std::optional<TrainResult> result_;
  std::string last_error_;
  std::string warnings_;  // each preceded by a blank
};

}  // namespace

TrainJob::TrainJob(const TrainGoal& goal, const std::vector<std::string>& bag_roots)
    : goal_(goal), bag_roots_(bag_roots) {}

TrainResult TrainJob::run(const FeedbackCallback& on_feedback, const WarningCallback& on_warning) {
  try {
    return train(on_feedback, on_warning);
  } catch (const std::exception& e) {
    return failure(e.what());
  }
}

TrainResult TrainJob::train(const FeedbackCallback& on_feedback,
                            const WarningCallback& on_warning) {
  const auto yaml = temporaryYaml(goal_.yaml);
  const std::string yaml_path = yaml ? yaml->path() : "";
  ChildProcess tool(trainCommand(goal_, bag_roots_, yaml_path), ChildProcess::Stderr::kPipe);
  ToolOutput output(goal_.model, on_feedback, on_warning);
  const auto on_output = [&output](const std::string& line) { output.onOutput(line); };
  const auto on_error = [&](std::string line) {
    if (yaml) boost::replace_all(line, yaml_path, "yaml of the goal");
    output.onError(line);
  };
  std::optional<Clock::time_point> deadline;
  while (tool.readLines(kPoll, on_output, on_error)) {
    if (cancelled_ && !deadline) {
      tool.interrupt();
      deadline = Clock::now() + kPatience;
    }
    if (deadline && Clock::now() > *deadline) tool.kill();
  }
  const int exit_status = tool.wait();
  if (cancelled_ && exit_status != 0) return failure("Cancelled; no model was written.");
  return output.result(exit_status);
}

}  // namespace place_recognition
