#include <filesystem>
#include <iostream>
#include <memory>

#include "base/bag_name.h"
#include "base/data_folder.h"
#include "base/place_name.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/bag_recording.h"
#include "tool/bag_info.h"
#include "tool/inputs.h"
#include "tool/model_info.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct InfoOptions {
  std::string name;
  InputOptions input;
  OutputOptions output;
};

/// The model file that `name` refers to. Throws Error for a file or folder that is not a model.
std::string modelPathOf(const std::string& name) {
  std::error_code ignored;
  const bool exists = std::filesystem::exists(name, ignored);
  const bool is_named = isPlainName(name) && std::filesystem::exists(modelPath(name), ignored);
  const std::string bag = is_named ? "" : bagBeside(name);
  if (!exists && !bag.empty()) throw Error("There is no model " + name + "; " + bag + ".");
  if (!exists || is_named) return modelPath(name);
  const std::string what = whyNoRecording(name);
  if (!what.empty()) throw Error(name + " is " + what + ".");
  if (std::filesystem::is_directory(name, ignored)) {
    throw Error(name + " is a folder; " + (bag.empty() ? "give a bag or a model" : bag) + ".");
  }
  const bool is_model = std::filesystem::path(name).extension() == ".places" || startsAsModel(name);
  if (!is_model) throw Error(name + " is neither a bag nor a model; give a .bag or .places file.");
  return name;
}

void showBag(const BagInfo& bag, const InfoOptions& options) {
  if (isActiveBag(options.name)) std::cerr << "warning: " << whyMisnamed(options.name) << ".\n";
  if (bag.other_images > 0) {
    std::cerr << "warning: " << options.name << ": " << counted(bag.other_images, "image")
              << (bag.other_images == 1 ? " is" : " are")
              << " more than a day away from the others and not within the duration and the labels "
                 "shown; train reads them.\n";
  }
  if (!bag.labels_note.empty()) std::cerr << "warning: " << bag.labels_note << "\n";
  if (options.output.json != "-") printBag(bag, options.name, options.output.text());
  options.output.writeJson(bagFigures(bag, options.name));
}

/// If only the labels cannot be read, shows the rest before it throws.
void showBag(const InfoOptions& options) {
  BagInfo bag;
  try {
    bag = bagInfo(options.name, options.input.bag);
  } catch (const Error&) {
    BagRecordingOptions without_labels = options.input.bag;
    without_labels.label = "any";
    bag = bagInfo(options.name, without_labels);
    bag.labels.clear();
    showBag(bag, options);
    throw;
  }
  showBag(bag, options);
}

void showModel(const InfoOptions& options) {
  options.input.requireBag({});
  const std::string path = modelPathOf(options.name);
  const Model model = loadModel(path);
  const std::uint64_t bytes = std::filesystem::file_size(path);
  if (options.output.json != "-") printModel(model, path, bytes, options.output.text());
  options.output.writeJson(modelFigures(model, path, bytes));
}

}  // namespace

void addInfo(CommandLine& tool) {
  Verb& verb = tool.verb("info", "Shows the contents of a model or a bag");
  const auto options = std::make_shared<InfoOptions>();
  verb.argument("NAME_OR_BAG", options->name, "Name or file of a model, or a bag");
  options->input.addTo(verb);
  verb.option("--initial-label", "PLACE", options->input.bag.initial_label,
              "The label before the first one of the bag, as said in an earlier part of its "
              "recording")
      .excludes("--label")
      .excludes("--labels")
      .group("Options for bags");
  options->output.addTo(verb);
  verb.footer("Example:\n  place_tool info office\n  place_tool info monday.bag");
  verb.run([options] {
    if (isBag(options->name)) {
      showBag(*options);
    } else {
      showModel(*options);
    }
  });
}

}  // namespace place_recognition::tool
