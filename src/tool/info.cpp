#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>

#include "base/data_folder.h"
#include "base/options.h"
#include "base/place_name.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/bag_recording.h"
#include "tool/inputs.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct InfoOptions {
  std::string name;
  InputOptions input;
  OutputOptions output;
};

/// Whether the machines of the model were judged by held-out images.
bool isValidated(const Model& model) {
  return model.validation.average_rate > 0 || model.validation.calibration_error > 0;
}

Json validationJson(const Model& model) {
  if (!isValidated(model)) return nullptr;
  return {{"average_rate", model.validation.average_rate},
          {"calibration_error", model.validation.calibration_error},
          {"rooms", model.validatedPlaces()}};
}

void printModel(const Model& model, const std::string& path, std::uint64_t bytes,
                std::ostream& out) {
  const Provenance& origin = model.provenance;
  out << std::left << "model            " << model.name << "\n"
      << "file             " << path << ", " << bytes << " bytes\n"
      << "version          " << model.version << ", written by place_recognition "
      << origin.package_version << "\n"
      << "trained on       ";
  for (std::size_t i = 0; i < origin.inputs.size(); ++i) {
    out << (i ? ", " : "") << origin.inputs[i];
  }
  if (model.images.known()) {
    out << "\nimages           " << model.images.width << " x " << model.images.height << ", "
        << (model.images.colour ? "colour" : "grey") << ", mean brightness "
        << std::lround(model.images.darkest) << " to " << std::lround(model.images.brightest);
    if (model.images.depth.known()) {
      out << ", of 16 bits (" << model.images.depth.low << " to " << model.images.depth.high << ")";
    }
  }
  out << "\nskipped images   " << origin.skipped_images << "\n"
      << "support vectors  " << model.supportVectorCount() << "\n"
      << std::fixed << std::setprecision(3) << "validation       ";
  if (!isValidated(model)) {
    out << "none\n";
  } else {
    out << "average rate " << model.validation.average_rate << ", calibration error "
        << model.validation.calibration_error << "\n";
  }
  out << std::fixed << std::setprecision(3) << "unknown below    " << model.unknown_threshold
      << "\n"
      << "places\n";
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    out << std::right << std::setw(8) << origin.place_images[i] << " images  " << model.places[i]
        << "\n";
  }
  if (!model.adjacency.empty()) {
    out << "adjoining " << writeAdjacency(model.adjacency, model.places);
  }
  if (model.cameras.known()) {
    out << "cameras, correlation of their errors\n" << std::fixed << std::setprecision(2);
    for (std::size_t a = 0; a < model.cameras.cameras.size(); ++a) {
      const auto row = static_cast<Eigen::Index>(a);
      for (Eigen::Index b = 0; b < model.cameras.coefficients.cols(); ++b) {
        out << std::setw(8) << model.cameras.coefficients(row, b);
      }
      out << "  " << model.cameras.cameras[a] << "\n";
    }
    out << std::defaultfloat;
  }
  out << "cues\n";
  for (std::size_t i = 0; i < model.options.cues.size(); ++i) {
    out << std::setw(8) << model.classifiers[i].supportVectorCount() << " vectors, weight "
        << model.cue_weights[i] << "  " << model.options.cues[i].name << "\n";
  }
  out << "options\n" << writeOptions(model.options) << std::flush;
}

Json modelFigures(const Model& model, const std::string& path, std::uint64_t bytes) {
  Json rooms = Json::object();
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    rooms[model.places[i]] = {{"count", model.provenance.place_images[i]}};
  }
  Json adjoining = Json::array();  // pairs
  for (int a = 0; a < static_cast<int>(model.places.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(model.places.size()); ++b) {
      if (model.adjacency.joined(a, b)) adjoining.push_back({model.places[a], model.places[b]});
    }
  }
  Json correlations = Json::array();  // one row per camera
  for (Eigen::Index a = 0; a < model.cameras.coefficients.rows(); ++a) {
    const Eigen::VectorXd row = model.cameras.coefficients.row(a);
    correlations.push_back(std::vector<double>(row.data(), row.data() + row.size()));
  }
  return {{"model", model.name},
          {"path", path},
          {"version", model.version},
          {"package_version", model.provenance.package_version},
          {"inputs", model.provenance.inputs},
          {"skipped_images", model.provenance.skipped_images},
          {"rooms", rooms},
          {"adjoining", adjoining},
          {"cameras", model.cameras.cameras},
          {"camera_correlations", correlations},
          {"support_vectors", model.supportVectorCount()},
          {"model_bytes", bytes},
          {"unknown_threshold", model.unknown_threshold},
          {"validation", validationJson(model)},
          {"image_size", {model.images.width, model.images.height}},
          {"image_depth", {model.images.depth.low, model.images.depth.high}},
          {"options", writeOptions(model.options)},
          {"asked", writeOptions(model.asked)}};
}

void printBag(const BagInfo& bag, const std::string& path, std::ostream& out) {
  out << "bag       " << path << "\n"
      << std::fixed << std::setprecision(1) << "duration  " << bag.duration << " s from "
      << bag.start << "\n"
      << "topics\n";
  for (const BagTopic& topic : bag.topics) {
    out << std::setw(8) << topic.messages << "  " << topic.name << "  " << topic.type;
    if (topic.width > 0) out << "  " << topic.width << "x" << topic.height;
    out << "\n";
  }
  const std::string source = bag.labels_file.empty() ? "" : " in " + bag.labels_file;
  out << (bag.labels.empty() ? "no labels" + source : "labels" + source + ", s since the start")
      << "\n";
  for (const BagLabel& label : bag.labels) {
    out << std::setw(8) << label.from << " .. " << std::setw(8) << label.to << "  " << label.place
        << "\n";
  }
  out << std::flush;
}

Json bagFigures(const BagInfo& bag, const std::string& path) {
  Json topics = Json::array();
  for (const BagTopic& topic : bag.topics) {
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages},
                      {"width", topic.width},
                      {"height", topic.height}});
  }
  Json labels = Json::array();
  for (const BagLabel& label : bag.labels) {
    labels.push_back({{"from", label.from}, {"to", label.to}, {"place", label.place}});
  }
  return {{"bag", path},
          {"start", bag.start},
          {"duration", bag.duration},
          {"other_images", bag.other_images},
          {"topics", topics},
          {"labels_file", bag.labels_file},
          {"labels", labels}};
}

/// The model file that `name` refers to. Throws Error for a file or folder that is not a model.
std::string modelPathOf(const std::string& name) {
  std::error_code ignored;
  const bool exists = std::filesystem::exists(name, ignored);
  if (!exists || (isPlainName(name) && std::filesystem::exists(modelPath(name), ignored))) {
    return modelPath(name);
  }
  const std::string what = whyNoRecording(name);
  if (!what.empty()) throw Error(name + " is " + what + ".");
  if (std::filesystem::is_directory(name, ignored)) {
    throw Error(name + " is a folder; give a bag or a model.");
  }
  const bool is_model = std::filesystem::path(name).extension() == ".places" || startsAsModel(name);
  if (!is_model) throw Error(name + " is neither a bag nor a model; give a .bag or .places file.");
  return name;
}

void info(const InfoOptions& options) {
  if (isBag(options.name)) {
    const BagInfo bag = bagInfo(options.name, options.input.bag);
    if (isActiveBag(options.name)) {
      std::cerr << "warning: " << options.name
                << " is complete but has the name of an active recording; rename it.\n";
    }
    if (bag.other_images > 0) {
      std::cerr
          << "warning: " << options.name << ": " << counted(bag.other_images, "image")
          << (bag.other_images == 1 ? " is" : " are")
          << " more than a day away from the others and not within the duration and the labels "
             "shown; train reads them.\n";
    }
    if (options.output.json != "-") printBag(bag, options.name, options.output.text());
    options.output.writeJson(bagFigures(bag, options.name));
    return;
  }
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
  verb.run([options] { info(*options); });
}

}  // namespace place_recognition::tool
