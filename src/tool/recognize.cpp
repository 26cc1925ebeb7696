#include <unistd.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>

#include "base/place_name.h"
#include "datasets/image_file.h"
#include "datasets/image_folder.h"
#include "evaluation/recording_recognizer.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "recognition/over_time/room_answer.h"
#include "ros/bags/bag_file.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/recording_parts.h"
#include "tool/unusable_images.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct RecognizeOptions {
  std::vector<std::string> inputs;
  std::string model;
  InputOptions input;
  OutputOptions output;
};

Json scores(const Model& model, const Recognition& answer) {
  Json scores = Json::object();
  for (std::size_t k = 0; k < model.places.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    scores[model.places[k]] = {{"probability", answer.probabilities(i)},
                               {"margin", answer.decision_values(i)}};
  }
  return scores;
}

/// The answer revised by the frames before and after, like `~smoothed`.
Json overTime(const Model& model, const FilteredAnswer& answer) {
  const RoomAnswer revised = roomAnswer(answer);
  Json probabilities = Json::object();
  for (std::size_t k = 0; k < model.places.size(); ++k) {
    probabilities[model.places[k]] = revised.probabilities[static_cast<Eigen::Index>(k)];
  }
  return {{"place", model.places[static_cast<std::size_t>(revised.place)]},
          {"known", revised.known},
          {"confidence", revised.confidence},
          {"evidence", revised.evidence},
          {"probabilities", probabilities}};
}

/// Names the place of one frame after another: one line each for a person, or one object each for a
/// program.
class Recognitions {
 public:
  explicit Recognitions(const RecognizeOptions& options)
      : output_(options.output),
        recognizer_(std::make_shared<const Model>(loadModel(modelPath(options.model)))) {
    for (const std::string& place : recognizer_.model().places) {
      place_width_ = std::max(place_width_, place.size());
    }
  }

  const LevelRange& levels() const { return recognizer_.model().images.levels; }

  /// A single image.
  void addImage(const Frame& frame) {
    endStream();
    if (isUsable(frame)) add(frame, recognizer_.recognizeImage(frame.image));
  }

  /// Begins the frames of `recording`. `in_time`: their stamps are in order of time.
  void startRecording(Recording& recording, bool in_time) {
    if (!in_time) endStream();
    recognizer_.begin(recording);
    smooths_ = in_time;
  }

  void addFrame(const Frame& frame) {
    recognizer_.take(frame);
    if (isUsable(frame)) add(frame, recognizer_.recognize(frame));
  }

  /// Throws Error if there was no usable image.
  void finish() {
    endStream();
    unusable_.requireOthers(frames_);
    unusable_.warn(std::cerr);
    writeJson();
  }

  /// Writes the answers so far.
  void writeJson() const {
    const bool to_file = !output_.json.empty() && output_.json != "-";
    if (to_file && !json_lines_.empty()) writeText(output_.json, json_lines_);
  }

 private:
  /// No frame will follow those of the recordings so far.
  void endStream() {
    recognizer_.smoother().finish();
    writeSmoothed();
    smooths_ = false;
  }

  /// An object, and whether its smoothed answer is still to come.
  struct Waiting {
    Json object;
    bool for_answer;
  };

  /// Reports what is wrong with a frame; false if there is no image.
  bool isUsable(const Frame& frame) {
    ++frames_;
    if (frame.image.empty()) {
      addUnusable(frame);
      return false;
    }
    for (const std::string& warning : recognizer_.judge(frame)) {
      std::cerr << "warning: " << frame.name << ": " << warning << "\n";
    }
    return true;
  }

  void add(const Frame& frame, const Recognition& answer) {
    const std::string place =
        answer.place < 0 ? "" : recognizer_.model().places[static_cast<std::size_t>(answer.place)];
    if (output_.json != "-") print(frame.name, answer.known ? place : kUnknownPlace, answer);
    if (output_.json.empty()) return;
    Json object = {{"image", frame.name},         {"place", place},
                   {"known", answer.known},       {"confidence", answer.confidence},
                   {"evidence", answer.evidence}, {"scores", scores(recognizer_.model(), answer)}};
    if (answer.place < 0) object["reason"] = answer.reason;
    if (smooths_) recognizer_.follow(frame, answer);
    write({std::move(object), smooths_});
  }

  void addUnusable(const Frame& frame) {
    unusable_.add(frame.name, frame.problem);
    if (output_.json != "-" && frames_ > 1) {
      output_.text() << frame.name << "  cannot be used: " << frame.problem << "\n";
    }
    if (output_.json.empty()) return;
    write({{{"image", frame.name},
            {"place", ""},
            {"known", false},
            {"confidence", 0},
            {"evidence", 0},
            {"scores", Json::object()},
            {"reason", frame.problem}},
           false});
  }

  /// Writes objects in the order of the frames, once the preceding ones are written.
  void write(Waiting waiting) {
    waiting_.push_back(std::move(waiting));
    writeSmoothed();
  }

  void writeSmoothed() {
    for (; !waiting_.empty(); waiting_.pop_front()) {
      Waiting& next = waiting_.front();
      FixedLagSmoother& smoother = recognizer_.smoother();
      if (next.for_answer && !smoother.ready()) return;
      if (next.for_answer) {
        next.object["smoothed"] = overTime(recognizer_.model(), smoother.next());
      }
      if (output_.json == "-") {
        std::cout << jsonLine(next.object) << std::flush;
      } else {
        json_lines_ += jsonLine(next.object);
      }
    }
  }

  void print(const std::string& name, const std::string& place, const Recognition& answer) {
    name_width_ = std::max(name_width_, name.size());
    std::ostream& out = output_.text();
    out << std::left << std::setw(static_cast<int>(name_width_)) << name << "  "
        << std::setw(static_cast<int>(place_width_)) << place << "  " << std::right << std::fixed
        << std::setprecision(2) << std::setw(5) << answer.confidence;
    if (answer.place < 0) out << "  " << answer.reason;
    out << "\n";
  }

  const OutputOptions& output_;
  RecordingRecognizer recognizer_;
  UnusableImages unusable_;
  std::size_t frames_ = 0;
  bool smooths_ = false;
  std::deque<Waiting> waiting_;
  std::string json_lines_;
  std::size_t name_width_ = 0;
  std::size_t place_width_ = std::string(kUnknownPlace).size();
};

/// An image, or runs.
struct Input {
  std::string image;
  std::vector<std::string> runs;
};

std::vector<Input> inputsOf(const RecognizeOptions& options) {
  std::vector<Input> inputs;
  std::vector<std::string> runs;
  for (const std::string& input : options.inputs) {
    const bool is_image = isImageName(input) && !std::filesystem::is_directory(input);
    if (is_image || startsAsImage(input)) {
      inputs.push_back({input, {}});
    } else {
      if (inputs.empty() || !inputs.back().image.empty()) inputs.emplace_back();
      for (const std::string& run : findRecordings({input})) {
        inputs.back().runs.push_back(run);
        runs.push_back(run);
      }
    }
  }
  options.input.requireBag(runs);
  return inputs;
}

void recognizeRun(const std::string& run, const InputOptions& input, Recognitions& recognitions,
                  const Progress& progress) {
  const std::unique_ptr<Recording> recording = input.open(run);
  const bool is_bag = isBag(run);
  recognitions.startRecording(*recording, is_bag);
  for (Frame frame; recording->next(frame);) {
    report(progress, "Recognizing " + run, recording->fraction());
    if (is_bag) frame.name = run + " " + frame.name;
    recognitions.addFrame(frame);
  }
  printWarnings(recording->warnings());
}

void recognize(const RecognizeOptions& options) {
  const std::vector<Input> inputs = inputsOf(options);
  Recognitions recognitions(options);
  // On a terminal, the lines with answers show the progress.
  const bool answers_are_seen = options.output.progress == "auto" && isatty(STDOUT_FILENO);
  ProgressDisplay display(answers_are_seen ? "none" : options.output.progress);
  const Progress progress = display.callback();
  InputOptions unlabelled = options.input;
  unlabelled.bag.label = "any";  // labels are not needed, right or wrong
  try {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (const RecordingPart& part : partsInOrder(inputs[i].runs, unlabelled.bag)) {
        recognizeRun(part.path, unlabelled, recognitions, progress);
      }
      if (inputs[i].image.empty()) continue;
      report(progress, "Recognizing", static_cast<double>(i) / inputs.size());
      Frame frame = imageFrame(inputs[i].image, recognitions.levels());
      frame.stamp = static_cast<double>(i);
      recognitions.addImage(frame);
    }
  } catch (...) {
    recognitions.writeJson();
    throw;
  }
  recognitions.finish();
}

}  // namespace

void addRecognize(CommandLine& tool) {
  Verb& verb = tool.verb("recognize", "Names the place in images");
  const auto options = std::make_shared<RecognizeOptions>();
  verb.argument("IMAGE_OR_INPUT", options->inputs,
                "Images (png, jpg, webp, bmp, tiff), bags or folders of room/image files");
  verb.option("--model", "NAME", options->model, "Name or file of the model").required();
  options->input.addImageTopicTo(verb);
  options->output.addTo(verb);
  verb.footer(
      "Prints one line per image: path, place (or unknown), confidence 0..1. With --json, prints "
      "one\n"
      "object per line: image, place, known, confidence, evidence and the scores of every place; "
      "for a\n"
      "bag also the smoothed answer, which uses the frames before and after. Unusable images are\n"
      "reported with the reason.\n"
      "Example:\n"
      "  place_tool recognize --model office now.jpg");
  verb.run([options] { recognize(*options); });
}

}  // namespace place_recognition::tool
