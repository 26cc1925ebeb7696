#include "tool/model_info.h"

#include <cmath>
#include <iomanip>
#include <ostream>

#include "base/options.h"
#include "base/text.h"

namespace place_recognition::tool {
namespace {

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

void printImages(const Model& model, std::ostream& out) {
  const ImageProfile& images = model.images;
  if (images.known()) {
    out << "images           " << sizeText(images.width, images.height) << ", "
        << (images.colour ? "colour" : "grey") << ", mean brightness "
        << std::lround(images.darkest) << " to " << std::lround(images.brightest);
    if (images.levels.known()) {
      out << ", of 16 bits (" << images.levels.low << " to " << images.levels.high << ")";
    }
    out << "\n";
  }
  out << "skipped images   " << model.provenance.skipped_images << "\n";
}

void printValidation(const Model& model, std::ostream& out) {
  out << std::fixed << std::setprecision(3) << "validation       ";
  if (!isValidated(model)) {
    out << "none\n";
  } else {
    out << "average rate " << model.validation.average_rate << ", calibration error "
        << model.validation.calibration_error << "\n";
  }
  out << "unknown below    " << model.unknown_threshold << "\n";
}

void printPlaces(const Model& model, std::ostream& out) {
  out << "places\n" << std::right;
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    out << std::setw(8) << model.provenance.place_images[i]
        << (model.provenance.place_images[i] == 1 ? " image   " : " images  ") << model.places[i]
        << "\n";
  }
  if (!model.adjacency.empty()) {
    out << "adjoining " << writeAdjacency(model.adjacency, model.places);
  }
}

void printCameras(const CameraCorrelation& cameras, std::ostream& out) {
  if (!cameras.known()) return;
  out << "cameras, correlation of their errors\n" << std::fixed << std::setprecision(2);
  for (std::size_t a = 0; a < cameras.cameras.size(); ++a) {
    const auto row = static_cast<Eigen::Index>(a);
    for (Eigen::Index b = 0; b < cameras.coefficients.cols(); ++b) {
      out << std::setw(8) << cameras.coefficients(row, b);
    }
    out << "  " << cameras.cameras[a] << "\n";
  }
  out << std::defaultfloat;
}

void printCues(const Model& model, std::ostream& out) {
  out << "cues\n";
  for (std::size_t i = 0; i < model.options.cues.size(); ++i) {
    out << std::setw(8) << model.classifiers[i].supportVectorCount() << " vectors, weight "
        << model.cue_weights[i] << "  " << model.options.cues[i].name << "\n";
  }
}

/// Pairs of adjoining places.
Json adjoiningJson(const Model& model) {
  Json adjoining = Json::array();
  for (int a = 0; a < static_cast<int>(model.places.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(model.places.size()); ++b) {
      if (model.adjacency.joined(a, b)) adjoining.push_back({model.places[a], model.places[b]});
    }
  }
  return adjoining;
}

/// One row per camera.
Json correlationsJson(const CameraCorrelation& cameras) {
  Json correlations = Json::array();
  for (Eigen::Index a = 0; a < cameras.coefficients.rows(); ++a) {
    const Eigen::VectorXd row = cameras.coefficients.row(a);
    correlations.push_back(std::vector<double>(row.data(), row.data() + row.size()));
  }
  return correlations;
}

}  // namespace

void printModel(const Model& model, const std::string& path, std::uint64_t bytes,
                std::ostream& out) {
  const Provenance& origin = model.provenance;
  out << std::left << "model            " << model.name << "\n"
      << "file             " << path << ", " << bytes << " bytes\n"
      << "version          " << model.version << ", written by place_recognition "
      << origin.package_version << "\n"
      << "trained on       " << listed(origin.inputs) << "\n";
  printImages(model, out);
  out << "support vectors  " << model.supportVectorCount() << "\n";
  printValidation(model, out);
  printPlaces(model, out);
  printCameras(model.cameras, out);
  printCues(model, out);
  out << "options\n" << writeOptions(model.options) << std::flush;
}

Json modelFigures(const Model& model, const std::string& path, std::uint64_t bytes) {
  Json rooms = Json::object();
  for (std::size_t i = 0; i < model.places.size(); ++i) {
    rooms[model.places[i]] = {{"count", model.provenance.place_images[i]}};
  }
  return {{"model", model.name},
          {"path", path},
          {"version", model.version},
          {"package_version", model.provenance.package_version},
          {"inputs", model.provenance.inputs},
          {"skipped_images", model.provenance.skipped_images},
          {"rooms", rooms},
          {"adjoining", adjoiningJson(model)},
          {"cameras", model.cameras.cameras},
          {"camera_correlations", correlationsJson(model.cameras)},
          {"support_vectors", model.supportVectorCount()},
          {"model_bytes", bytes},
          {"unknown_threshold", model.unknown_threshold},
          {"validation", validationJson(model)},
          {"image_size", {model.images.width, model.images.height}},
          {"image_depth", {model.images.levels.low, model.images.levels.high}},
          {"options", writeOptions(model.options)},
          {"asked", writeOptions(model.asked)}};
}

}  // namespace place_recognition::tool
