#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "ros/bags/bag_file.h"
#include "tool/inputs.h"
#include "tool/package_folder.h"
#include "tool/recording_parts.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct LabelOptions {
  std::vector<std::string> inputs;
  std::string model;
  int port = 0;
  bool no_browser = false;
  InputOptions input;
};

/// The bags among the inputs; each can be read and labelled with a file beside it.
std::vector<std::string> checkedBags(const LabelOptions& options) {
  const std::vector<std::string> bags = findRecordings(options.inputs);
  std::map<std::string, std::string> owners;  // of the files of labels
  for (const std::string& bag : bags) {
    if (!isBag(bag)) {
      throw Error(bag + " is a folder of images, which are labelled by their folders; give bags.");
    }
    bagInfo(bag, options.input.bag);  // throws if it cannot be read
    const std::string labels = writtenLabelsFile(std::filesystem::absolute(bag).lexically_normal());
    const auto [owner, is_new] = owners.emplace(labels, bag);
    if (!is_new) {
      throw Error("The labels of " + owner->second + " and of " + bag + " would both be saved in " +
                  labels + "; rename one of the bags.");
    }
  }
  if (bags.size() > 1 && !options.input.bag.labels_file.empty()) {
    throw Error("--labels " + options.input.bag.labels_file +
                " applies to a single bag; give one.");
  }
  return bags;
}

/// Replaces this process by the program with these arguments; throws if that fails.
[[noreturn]] void execute(std::vector<std::string> arguments) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  throw Error("Cannot start " + arguments[0] + ": " + std::strerror(errno) + "; install python3.");
}

/// The page's server is a Python program, label_page/.
void label(const LabelOptions& options) {
  if (!options.model.empty()) loadModel(modelPath(options.model));  // throws if it cannot be used
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> arguments{PLACE_RECOGNITION_PYTHON, "-B", packageFolder("label_page"),
                                     "--tool", program};
  const BagRecordingOptions& bag = options.input.bag;
  if (bag.image_topics.size() > 1) {
    throw UsageError("--image-topic: the page shows only one camera; name one");
  }
  const auto pass = [&arguments](const char* option, const std::string& value) {
    if (!value.empty()) arguments.push_back(std::string(option) + "=" + value);
  };
  pass("--model", options.model);
  pass("--port", std::to_string(options.port));
  pass("--image-topic", bag.image_topics.empty() ? "" : bag.image_topics.front());
  const bool has_topic = bag.label.empty() && bag.labels_file.empty();
  pass("--label-topic", has_topic ? bag.label_topic : "");
  pass("--labels", bag.labels_file);
  pass("--label", bag.label);
  const std::vector<RecordingPart> bags = partsInOrder(checkedBags(options), bag);
  for (const RecordingPart& part : bags) {
    arguments.push_back("--initial-label=" + part.initial_label);
  }
  if (options.no_browser) arguments.emplace_back("--no-browser");
  arguments.emplace_back("--");
  for (const RecordingPart& part : bags) arguments.push_back(part.path);
  execute(std::move(arguments));
}

}  // namespace

void addLabel(CommandLine& tool) {
  Verb& verb = tool.verb("label", "Opens a page in the browser for labelling bags");
  const auto options = std::make_shared<LabelOptions>();
  verb.argument(
      "RUN", options->inputs,
      "A bag; several, such as the parts of a split recording, are shown one after the other");
  verb.option("--model", "NAME", options->model, "Show this model's answers below the labels");
  verb.option("--port", "N", options->port, "Port of the page's address; 0: any free port")
      .range(0, 65535);
  verb.flag("--no-browser", options->no_browser, "Only print the page's address");
  options->input.addTo(verb);
  verb.footer(
      "Save writes RUN.labels.yaml beside each RUN.bag and keeps the previous file as\n"
      "RUN.labels.yaml.old; nothing else is written. The page is reachable from this computer "
      "only.\n"
      "Closing it, or Ctrl-C, ends the program.\n"
      "Example:\n"
      "  place_tool label tuesday.bag --model monday");
  verb.run([options] { label(*options); });
}

}  // namespace place_recognition::tool
