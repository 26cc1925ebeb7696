#include <iostream>
#include <memory>

#include "base/text.h"
#include "place_recognition/error.h"
#include "recognition/frames/cue_extraction.h"
#include "recognition/frames/mirror_search.h"
#include "recognition/model/embeddings.h"
#include "tool/configuration.h"
#include "tool/inputs.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct FeaturesOptions {
  std::string image;
  ConfigurationOptions configuration;
};

/// A text that gives the same float again.
std::string formatFloat(float value) { return significant(static_cast<double>(value), 9); }

void print(const std::monostate&) {}

void print(const SparseVector& vector) {
  for (std::size_t i = 0; i < vector.size(); ++i) {
    std::cout << (i ? " " : "") << vector.indices[i] << ':' << formatFloat(vector.values[i]);
  }
  std::cout << '\n';
}

void print(const DenseVector& vector) {
  for (std::size_t i = 0; i < vector.values.size(); ++i) {
    std::cout << (i ? " " : "") << i << ':' << formatFloat(vector.values[i]);
  }
  std::cout << '\n';
}

void print(const DescriptorSet& set) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (std::size_t d = 0; d < DescriptorSet::kDimension; ++d) {
      std::cout << (d ? " " : "") << static_cast<int>(set.row(i)[d]);
    }
    std::cout << '\n';
  }
}

/// Like the preset crfh.
TrainingOptions defaultOptions() {
  TrainingOptions options;
  options.cues = {CueOptions()};
  return options;
}

void features(const FeaturesOptions& options) {
  const TrainingOptions training_options =
      withNetworks(options.configuration.read(defaultOptions()));
  const cv::Mat image = readImage(options.image);
  CueExtraction extraction(withMirror(training_options, image, options.image), ImageProfile());
  std::vector<Feature> features;
  if (!extraction.extract(image, features)) {
    throw Error(options.image + " has no feature: " + extraction.reason() +
                "; use a larger image with more detail, or another --config.");
  }
  for (std::size_t c = 0; c < features.size(); ++c) {
    if (features.size() > 1) std::cout << "# " << training_options.cues[c].name << '\n';
    std::visit([](const auto& feature) { print(feature); }, features[c]);
  }
  std::cout << std::flush;
}

}  // namespace

void addFeatures(CommandLine& tool) {
  Verb& verb = tool.verb("features", "Prints the feature of an image");
  const auto options = std::make_shared<FeaturesOptions>();
  verb.argument("IMAGE", options->image, "Image (png, jpg)");
  options->configuration.addTo(verb, defaultOptions());
  verb.footer(
      "Prints a histogram as one line of index:value, and each local feature as a line of 128\n"
      "numbers 0..255. The default configuration is the preset crfh. Several cues follow each "
      "other,\n"
      "each after a line '# NAME'.\n"
      "Example:\n"
      "  place_tool features now.jpg --config crfh_colour");
  verb.run([options] { features(*options); });
}

}  // namespace place_recognition::tool
