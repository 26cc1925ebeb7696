#include "recognition/model/model_message.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/options.h"
#include "base/place_name.h"
#include "base/require.h"
#include "place_recognition/error.h"
#include "recognition/model/embeddings.h"

namespace place_recognition {
namespace {

/// Far above what a configuration needs; keeps foreign text away from the YAML parser.
constexpr std::size_t kMaxOptionsBytes = 1 << 16;
/// The text of options that are not longer than that.
YAML::Node parseOptions(const std::string& text) {
  require(text.size() <= kMaxOptionsBytes, "its options are too long");
  return parseYaml(text, "its configuration");
}

/// Where blocks have no length, the gap is a number of frames, of an earlier version.
void readTrainingOptions(const std::string& text, TrainingOptions& options) {
  const YAML::Node node = parseOptions(text);
  readOptions(node, "", options);
  const YAML::Node validation = node["validation"];
  if (!(validation && validation["block"])) options.validation.gap = 0;
  options.check();
}

/// More runs than a command line can name.
constexpr std::size_t kMaxInputs = 100000;
/// Limit of the length of an embedding.
constexpr std::uint32_t kMaxDimension = 1 << 20;

template <typename Numbers>
void requireFinite(const Numbers& numbers, const char* otherwise) {
  for (const double number : numbers) require(std::isfinite(number), otherwise);
}

/// Symmetric, positive semidefinite but for rounding, and no larger than what colours can vary by.
bool isSoundCovariance(const Eigen::Matrix3d& covariance) {
  constexpr double kRounding = 1e-9;
  constexpr double kLargest = 100;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() >= -kRounding &&
         solver.eigenvalues().maxCoeff() <= kLargest;
}

bool isFraction(double number) { return number >= 0 && number <= 1; }

std::string joined(const std::vector<std::string>& texts) {
  std::string bytes;
  for (const std::string& text : texts) bytes.append(text).push_back('\0');
  return bytes;
}

/// What joined() was given. The texts are counted before memory is taken for them: an empty one has
/// one byte in a file and many in memory.
std::vector<std::string> separated(const std::string& bytes, std::size_t most) {
  require(bytes.empty() || bytes.back() == '\0', "a text has no end");
  require(static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\0')) <= most,
          "it names too many places or inputs");
  std::vector<std::string> texts;
  for (std::size_t begin = 0; begin < bytes.size(); begin += texts.back().size() + 1) {
    texts.emplace_back(&bytes[begin]);
  }
  return texts;
}

void readNames(const proto::Model& message, Model& model) {
  model.places = separated(message.places(), kMaxPlaces);
  require(model.places.size() >= 2, "it knows fewer than two places");
  for (std::size_t k = 0; k < model.places.size(); ++k) {
    require(isPlaceName(model.places[k]), "the name of a place is not printable UTF-8 text");
    require(k == 0 || model.places[k - 1] < model.places[k], "the names of places do not ascend");
  }
}

void readCueWeights(const proto::Model& message, Model& model) {
  require(static_cast<std::size_t>(message.cue_weights_size()) == model.options.cues.size(),
          "it has not one weight per cue");
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
    message.add_embedding_dimensions(static_cast<std::uint32_t>(embedding->loaded->dimension));
    checksums.push_back(embedding->loaded->sha256);
  }
  message.set_embedding_networks(joined(checksums));
}

/// The networks without their bytes.
void readEmbeddings(const proto::Model& message, Model& model) {
  const std::vector<EmbeddingOptions*> embeddings = embeddingsOf(model.options);
  const std::vector<std::string> checksums =
      separated(message.embedding_networks(), embeddings.size());
  require(static_cast<std::size_t>(message.embedding_dimensions_size()) == embeddings.size() &&
              checksums.size() == embeddings.size(),
          "it has not one network for each cue that needs one");
  for (std::size_t i = 0; i < embeddings.size(); ++i) {
    const std::uint32_t dimension = message.embedding_dimensions(static_cast<int>(i));
    require(dimension > 0 && dimension <= kMaxDimension, "the output of a network is too large");
    require(checksums[i].size() == 64 &&
                checksums[i].find_first_not_of("0123456789abcdef") == std::string::npos,
            "the checksum of a network is not one");
    embeddings[i]->loaded = std::make_shared<const Network>(Network{"", dimension, checksums[i]});
  }
}

void readCalibration(const proto::Model& message, Model& model) {
  model.calibration.slope = message.calibration_slope();
  require(std::isfinite(model.calibration.slope) && model.calibration.slope > 0,
          "the slope of the calibration is not a positive number");
  require(message.evidence_weights_size() == 3, "it does not have three weights of evidence");
  requireFinite(message.evidence_weights(), "a weight of evidence is not finite");
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

void writeHeldOut(const HeldOutFrames& frames, proto::Model& message) {
  for (std::size_t i = 0; i < frames.places.size(); ++i) {
    message.add_held_out_frames(static_cast<std::uint32_t>(frames.places[i]));
    message.add_held_out_frames(static_cast<std::uint32_t>(frames.folds[i]));
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t c = 0; c < frames.decision_values.size(); ++c) {
      message.add_held_out_values(frames.familiarity[c][row]);
      for (Eigen::Index k = 0; k < frames.decision_values[c].cols(); ++k) {
        message.add_held_out_values(frames.decision_values[c](row, k));
      }
    }
  }
}

void readHeldOut(const proto::Model& message, Model& model) {
  const auto places = static_cast<Eigen::Index>(model.places.size());
  const std::size_t cues = model.options.cues.size();
  const auto size = static_cast<std::size_t>(message.held_out_frames_size());
  const std::size_t count = size / 2;
  require(size % 2 == 0 && count <= kMaxHeldOutFrames, "its held-out frames are not countable");
  require(static_cast<std::size_t>(message.held_out_values_size()) ==
              count * cues * (model.places.size() + 1),
          "it has not a decision value per place for each held-out frame");
  HeldOutFrames& frames = model.held_out;
  frames.decision_values.assign(cues, Eigen::MatrixXf(static_cast<Eigen::Index>(count), places));
  frames.familiarity.assign(cues, Eigen::VectorXf(static_cast<Eigen::Index>(count)));
  int next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t place = message.held_out_frames(static_cast<int>(2 * i));
    const std::uint32_t fold = message.held_out_frames(static_cast<int>(2 * i + 1));
    require(place < model.places.size() && fold < ValidationOptions::kMaxFolds,
            "a held-out frame shows a place that there is not");
    frames.places.push_back(static_cast<int>(place));
    frames.folds.push_back(static_cast<int>(fold));
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t c = 0; c < cues; ++c) {
      frames.familiarity[c][row] = message.held_out_values(next++);
      require(!std::isinf(frames.familiarity[c][row]), "the familiarity of a frame is infinite");
      for (Eigen::Index k = 0; k < places; ++k) {
        frames.decision_values[c](row, k) = message.held_out_values(next++);
        require(std::isfinite(frames.decision_values[c](row, k)),
                "a held-out decision value is not finite");
      }
    }
  }
}

void writeAdjacency(const Adjacency& adjacency, proto::Model& message) {
  const int places = static_cast<int>(adjacency.places());
  for (int a = 0; a < places; ++a) {
    for (int b = a + 1; b < places; ++b) {
      if (!adjacency.joined(a, b)) continue;
      message.add_adjacency(static_cast<std::uint32_t>(a));
      message.add_adjacency(static_cast<std::uint32_t>(b));
    }
  }
}

void readAdjacency(const proto::Model& message, Model& model) {
  const std::uint64_t places = model.places.size();
  model.adjacency = Adjacency(places);
  require(message.adjacency_size() % 2 == 0, "the map of adjoining rooms has half a pair");
  std::uint64_t before = 0;  // no pair has a second place 0
  for (int i = 0; i < message.adjacency_size(); i += 2) {
    const std::uint64_t a = message.adjacency(i);
    const std::uint64_t b = message.adjacency(i + 1);
    require(a < b && b < places, "the map of adjoining rooms names a place that there is not");
    require(a * places + b > before, "the map of adjoining rooms is not in order");
    before = a * places + b;
    model.adjacency.join(static_cast<int>(a), static_cast<int>(b));
  }
}

void writeColours(const ColourStatistics& colours, proto::Model& message) {
  for (Eigen::Index k = 0; k < colours.means.rows(); ++k) {
    for (int c = 0; c < 3; ++c) message.add_colour_means(colours.means(k, c));
  }
  if (!colours.known()) return;
  for (int c = 0; c < 3; ++c) {
    for (int d = c; d < 3; ++d) message.add_colour_covariance(colours.covariance(c, d));
  }
}

void readColours(const proto::Model& message, Model& model) {
  if (message.colour_means_size() == 0) return;
  const auto places = static_cast<Eigen::Index>(model.places.size());
  require(message.colour_means_size() == 3 * places && message.colour_covariance_size() == 6,
          "its statistics of colours are not complete");
  requireFinite(message.colour_means(), "a colour is not finite");
  requireFinite(message.colour_covariance(), "a variance of colours is not finite");
  ColourStatistics& colours = model.colours;
  colours.means.resize(places, 3);
  for (Eigen::Index k = 0; k < places; ++k) {
    for (int c = 0; c < 3; ++c) {
      colours.means(k, c) = message.colour_means(static_cast<int>(3 * k + c));
    }
  }
  int next = 0;
  for (int c = 0; c < 3; ++c) {
    for (int d = c; d < 3; ++d) {
      colours.covariance(c, d) = colours.covariance(d, c) = message.colour_covariance(next++);
    }
  }
  require(isSoundCovariance(colours.covariance), "its statistics of colours contradict themselves");
}

void writeCameras(const CameraCorrelation& cameras, proto::Model& message) {
  if (!cameras.known()) return;
  message.set_cameras(joined(cameras.cameras));
  const auto count = static_cast<Eigen::Index>(cameras.cameras.size());
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a + 1; b < count; ++b) {
      message.add_camera_correlations(cameras.coefficients(a, b));
    }
  }
}

void readCameras(const proto::Model& message, Model& model) {
  CameraCorrelation& cameras = model.cameras;
  cameras.cameras = separated(message.cameras(), kMaxCameras);
  const auto count = static_cast<Eigen::Index>(cameras.cameras.size());
  require(message.camera_correlations_size() == count * (count - 1) / 2,
          "it has not one correlation for each pair of cameras");
  cameras.coefficients.setIdentity(count, count);
  int next = 0;
  for (Eigen::Index a = 0; a < count; ++a) {
    require(isUtf8(cameras.cameras[static_cast<std::size_t>(a)]),
            "the topic of a camera is not UTF-8 text");
    for (Eigen::Index b = a + 1; b < count; ++b) {
      const double correlation = message.camera_correlations(next++);
      require(isFraction(correlation), "the correlation of two cameras is not in 0..1");
      cameras.coefficients(a, b) = cameras.coefficients(b, a) = correlation;
    }
  }
}

void writeImages(const ImageProfile& images, proto::Model& message) {
  if (!images.known()) return;
  proto::ImageProfile& profile = *message.mutable_images();
  profile.set_width(static_cast<std::uint32_t>(images.width));
  profile.set_height(static_cast<std::uint32_t>(images.height));
  profile.set_colour(images.colour);
  profile.set_darkest(images.darkest);
  profile.set_brightest(images.brightest);
  profile.set_depth_low(images.depth.low);
  profile.set_depth_high(images.depth.high);
}

void readImages(const proto::Model& message, Model& model) {
  if (!message.has_images()) return;
  constexpr std::uint32_t kMaxSide = 1u << 16;
  const proto::ImageProfile& profile = message.images();
  const auto isSide = [](std::uint32_t side) { return side >= 1 && side <= kMaxSide; };
  require(isSide(profile.width()) && isSide(profile.height()),
          "the size of the images that it was trained on is not in 1..65536");
  require(profile.darkest() >= 0 && profile.darkest() <= profile.brightest() &&
              profile.brightest() <= 255,
          "the brightness of the images that it was trained on is not in 0..255");
  require(profile.depth_low() <= profile.depth_high() && profile.depth_high() < 1u << 16,
          "the depth of the images that it was trained on is not in 0..65535");
  model.images = {static_cast<int>(profile.width()),
                  static_cast<int>(profile.height()),
                  profile.colour(),
                  profile.darkest(),
                  profile.brightest(),
                  {profile.depth_low(), profile.depth_high()}};
}

void readProvenance(const proto::Provenance& message, Model& model) {
  require(static_cast<std::size_t>(message.place_images_size()) == model.places.size(),
          "the numbers of images are not those of its places");
  Provenance& provenance = model.provenance;
  provenance.inputs = separated(message.inputs(), kMaxInputs);
  provenance.place_images.assign(message.place_images().begin(), message.place_images().end());
  provenance.skipped_images = message.skipped_images();
  provenance.package_version = message.package_version();
  require(isPlaceName(provenance.package_version), "its package version is not printable text");
}

}  // namespace

proto::Model toMessage(const Model& model) {
  proto::Model message;
  message.set_options(writeOptions(model.options));
  message.set_asked(writeOptions(model.asked));
  message.set_places(joined(model.places));
  for (const double weight : model.cue_weights) message.add_cue_weights(weight);
  message.set_calibration_slope(model.calibration.slope);
  const EvidenceWeights& weights = model.calibration.weights;
  for (const double weight : {weights.decision_values, weights.familiarity, weights.offset}) {
    message.add_evidence_weights(weight);
  }
  message.set_unknown_threshold(model.unknown_threshold);
  message.set_validation_average_rate(model.validation.average_rate);
  message.set_validation_calibration_error(model.validation.calibration_error);
  writeColours(model.colours, message);
  writeHeldOut(model.held_out, message);
  writeAdjacency(model.adjacency, message);
  writeImages(model.images, message);
  writeCameras(model.cameras, message);
  writeEmbeddings(model, message);

  proto::Provenance& provenance = *message.mutable_provenance();
  provenance.set_inputs(joined(model.provenance.inputs));
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
  readColours(message, model);
  readHeldOut(message, model);
  readAdjacency(message, model);
  readImages(message, model);
  readCameras(message, model);
  readProvenance(message.provenance(), model);
  return model;
}

}  // namespace place_recognition
