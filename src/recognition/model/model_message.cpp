#include "recognition/model/model_message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/options.h"
#include "base/place_name.h"
#include "base/require.h"
#include "recognition/model/embeddings.h"
#include "recognition/model/message_parts.h"

namespace place_recognition {
namespace {

/// Far more than a configuration needs; keeps foreign text away from the YAML parser.
constexpr std::size_t kMaxOptionsBytes = 1 << 16;
/// Parses options of at most that length.
YAML::Node parseOptions(const std::string& text) {
  require(text.size() <= kMaxOptionsBytes, "its options are too long");
  return parseYaml(text, "its configuration");
}

/// If blocks have no length, the text is from an earlier version, whose gap is a number of frames.
void readTrainingOptions(const std::string& text, TrainingOptions& options) {
  const YAML::Node node = parseOptions(text);
  readOptions(node, "", options);
  const YAML::Node validation = node["validation"];
  if (!(validation && validation["block"])) options.validation.gap = 0;
  options.check();
}

/// More runs than a command line can name.
constexpr std::size_t kMaxInputs = 100000;
/// Maximum dimension of an embedding.
constexpr std::uint32_t kMaxDimension = 1 << 20;

void readNames(const proto::Model& message, Model& model) {
  model.places = separated(message.places(), kMaxPlaces);
  require(model.places.size() >= 2, "it knows fewer than two places");
  for (std::size_t k = 0; k < model.places.size(); ++k) {
    require(isPlaceName(model.places[k]), "the name of a place is not printable UTF-8 text");
    require(k == 0 || model.places[k - 1] < model.places[k],
            "the names of places are not in ascending order");
  }
}

void readCueWeights(const proto::Model& message, Model& model) {
  require(static_cast<std::size_t>(message.cue_weights_size()) == model.options.cues.size(),
          "it does not have one weight per cue");
  double sum = 0;
  for (const double weight : message.cue_weights()) {
    require(isFraction(weight), "the weight of a cue is not in 0..1");
    sum += weight;
  }
  require(std::abs(sum - 1) < 1e-9, "the weights of the cues do not sum to one");
  model.cue_weights.assign(message.cue_weights().begin(), message.cue_weights().end());
}

void writeEmbeddings(const Model& model, proto::Model& message) {
  std::vector<std::string> checksums;
  for (const EmbeddingOptions* embedding : embeddingsOf(model.options)) {
    message.add_embedding_dimensions(static_cast<std::uint32_t>(embedding->dimension));
    checksums.push_back(embedding->loaded->sha256);
  }
  message.set_embedding_networks(joined(checksums));
}

/// Reads the networks without their bytes.
void readEmbeddings(const proto::Model& message, Model& model) {
  const std::vector<EmbeddingOptions*> embeddings = embeddingsOf(model.options);
  const std::vector<std::string> checksums =
      separated(message.embedding_networks(), embeddings.size());
  require(static_cast<std::size_t>(message.embedding_dimensions_size()) == embeddings.size() &&
              checksums.size() == embeddings.size(),
          "it does not have one network per cue that needs one");
  for (std::size_t i = 0; i < embeddings.size(); ++i) {
    const std::uint32_t dimension = message.embedding_dimensions(static_cast<int>(i));
    require(dimension > 0 && dimension <= kMaxDimension, "the output of a network is too large");
    require(checksums[i].size() == 64 &&
                checksums[i].find_first_not_of("0123456789abcdef") == std::string::npos,
            "the checksum of a network is malformed");
    embeddings[i]->dimension = dimension;
    embeddings[i]->loaded = std::make_shared<const Network>(Network{"", checksums[i]});
  }
}

void readCalibration(const proto::Model& message, Model& model) {
  model.decision_limit = message.decision_limit();
  require(std::isfinite(model.decision_limit) && model.decision_limit >= 0,
          "the limit of decision values is not a number >= 0");
  model.calibration.slope = message.calibration_slope();
  require(std::isfinite(model.calibration.slope) && model.calibration.slope > 0,
          "the slope of the calibration is not a positive number");
  require(message.evidence_weights_size() == 3, "it does not have three weights of evidence");
  constexpr double kLargestWeight = 1e30;  // sums of products with decision values stay finite
  for (const double weight : message.evidence_weights()) {
    require(std::abs(weight) <= kLargestWeight, "a weight of evidence is too large");
  }
  model.calibration.weights = {message.evidence_weights(0), message.evidence_weights(1),
                               message.evidence_weights(2)};
  model.unknown_threshold = message.unknown_threshold();
  model.validation.average_rate = message.validation_average_rate();
  model.validation.calibration_error = message.validation_calibration_error();
  require(isFraction(model.unknown_threshold), "the threshold of 'unknown' is not in 0..1");
  require(
      isFraction(model.validation.average_rate) && isFraction(model.validation.calibration_error),
      "the validation is not in 0..1");
}

/// The sketches of the `inputs` runs; empty ones from a file of an earlier version.
std::vector<RunSketch> readSketches(const proto::Provenance& message, std::size_t inputs) {
  std::vector<RunSketch> sketches(inputs);
  require(message.image_hash_counts().empty() ||
              static_cast<std::size_t>(message.image_hash_counts_size()) == inputs,
          "it does not have one number of hashes per run");
  int next = 0;
  for (int i = 0; i < message.image_hash_counts_size(); ++i) {
    const std::uint32_t count = message.image_hash_counts(i);
    require(count <= RunSketch::kMaxHashes &&
                static_cast<int>(count) <= message.image_hashes_size() - next,
            "the number of hashes of a run is too large");
    for (std::uint32_t n = 0; n < count; ++n, ++next) {
      require(n == 0 || message.image_hashes(next - 1) < message.image_hashes(next),
              "the hashes of a run are not in ascending order");
      sketches[static_cast<std::size_t>(i)].add(message.image_hashes(next));
    }
  }
  require(next == message.image_hashes_size(), "it has hashes of no run");
  return sketches;
}

void readProvenance(const proto::Provenance& message, Model& model) {
  require(static_cast<std::size_t>(message.place_images_size()) == model.places.size(),
          "it does not have one number of images per place");
  Provenance& provenance = model.provenance;
  provenance.inputs = separated(message.inputs(), kMaxInputs);
  provenance.sketches = readSketches(message, provenance.inputs.size());
  provenance.place_images.assign(message.place_images().begin(), message.place_images().end());
  provenance.skipped_images = message.skipped_images();
  provenance.package_version = message.package_version();
  require(isPlaceName(provenance.package_version), "its package version is not printable text");
}

}  // namespace

std::string joined(const std::vector<std::string>& texts) {
  std::string bytes;
  for (const std::string& text : texts) bytes.append(text).push_back('\0');
  return bytes;
}

std::vector<std::string> separated(const std::string& bytes, std::size_t most) {
  require(bytes.empty() || bytes.back() == '\0', "a text is not terminated");
  // Counted before memory is allocated for the texts, because an empty one takes one byte in a file
  // but many in memory.
  require(static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\0')) <= most,
          "it names too many places or inputs");
  std::vector<std::string> texts;
  for (std::size_t begin = 0; begin < bytes.size(); begin += texts.back().size() + 1) {
    texts.emplace_back(&bytes[begin]);
  }
  return texts;
}

proto::Model toMessage(const Model& model) {
  proto::Model message;
  message.set_options(writeOptions(model.options));
  message.set_asked(writeOptions(model.asked));
  message.set_places(joined(model.places));
  for (const double weight : model.cue_weights) message.add_cue_weights(weight);
  message.set_decision_limit(model.decision_limit);
  message.set_calibration_slope(model.calibration.slope);
  const EvidenceWeights& weights = model.calibration.weights;
  for (const double weight : {weights.decision_values, weights.familiarity, weights.offset}) {
    message.add_evidence_weights(weight);
  }
  message.set_unknown_threshold(model.unknown_threshold);
  message.set_validation_average_rate(model.validation.average_rate);
  message.set_validation_calibration_error(model.validation.calibration_error);
  writeTrainingData(model, message);
  writeEmbeddings(model, message);

  proto::Provenance& provenance = *message.mutable_provenance();
  provenance.set_inputs(joined(model.provenance.inputs));
  for (const RunSketch& sketch : model.provenance.sketches) {
    provenance.add_image_hash_counts(static_cast<std::uint32_t>(sketch.hashes().size()));
    for (const std::uint64_t hash : sketch.hashes()) provenance.add_image_hashes(hash);
  }
  for (const std::uint64_t count : model.provenance.place_images) {
    provenance.add_place_images(count);
  }
  provenance.set_skipped_images(model.provenance.skipped_images);
  provenance.set_package_version(model.provenance.package_version);
  return message;
}

Model fromMessage(const proto::Model& message) {
  Model model;
  readTrainingOptions(message.options(), model.options);
  readTrainingOptions(message.asked().empty() ? message.options() : message.asked(), model.asked);
  readEmbeddings(message, model);
  readNames(message, model);
  readCueWeights(message, model);
  readCalibration(message, model);
  readTrainingData(message, model);
  readProvenance(message.provenance(), model);
  return model;
}

}  // namespace place_recognition
