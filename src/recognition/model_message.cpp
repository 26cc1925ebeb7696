#include "recognition/model_message.h"

#include <cmath>
#include <cstdint>

#include "base/options.h"
#include "learning/machines.h"
#include "learning/support_set.h"
#include "place_recognition/error.h"
#include "recognition/names.h"
#include "recognition/vectors_message.h"

namespace place_recognition {
namespace {

/// Far above what a configuration needs; keeps foreign text away from the YAML parser.
constexpr std::size_t kMaxOptionsBytes = 1 << 16;

void require(bool condition, const char* otherwise) {
  if (!condition) throw Error(otherwise);
}

template <typename Numbers>
void requireFinite(const Numbers& numbers, const char* otherwise) {
  for (const double number : numbers) require(std::isfinite(number), otherwise);
}

bool isShare(double number) { return number >= 0 && number <= 1; }

Eigen::RowVectorXd rowVector(const google::protobuf::RepeatedField<double>& numbers) {
  return Eigen::Map<const Eigen::RowVectorXd>(numbers.data(), numbers.size());
}

void append(const Eigen::RowVectorXd& numbers, google::protobuf::RepeatedField<double>* field) {
  field->Add(numbers.data(), numbers.data() + numbers.size());
}

proto::Classifier toMessage(const Classifier& classifier, proto::Vectors::Kind kind) {
  proto::Classifier message;
  *message.mutable_support_vectors() = toMessage(classifier.supportSet().vectors(), kind);
  const Machines& machines = classifier.machines();
  for (Eigen::Index i = 0; i < machines.weights.rows(); ++i) {
    append(machines.weights.row(i), message.mutable_weights());
  }
  append(machines.biases, message.mutable_biases());
  for (const int place : classifier.vectorPlaces()) {
    message.add_vector_places(static_cast<std::uint32_t>(place));
  }
  return message;
}

Classifier classifierFromMessage(const proto::Classifier& message, const CueOptions& cue,
                                 const Model& model) {
  Machines machines;
  machines.places = model.places.size();
  machines.one_against_one = model.options.svm.multiclass == "one-against-one";
  require(static_cast<std::uint64_t>(message.biases_size()) ==
              machineCount(machines.places, machines.one_against_one),
          "the number of machines is not that of the places");
  const std::uint64_t vectors = static_cast<std::uint64_t>(message.support_vectors().sizes_size());
  require(static_cast<std::uint64_t>(message.weights_size()) == vectors * message.biases_size(),
          "there are not as many weights as support vectors and machines");
  requireFinite(message.weights(), "a weight is not finite");
  requireFinite(message.biases(), "a bias is not finite");

  std::vector<int> vector_places;
  for (const std::uint32_t place : message.vector_places()) {
    require(place < machines.places, "a support vector is of a place that there is not");
    vector_places.push_back(static_cast<int>(place));
  }
  require(vector_places.size() == vectors,
          "the places of the support vectors are not as many as these");

  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  machines.weights = Eigen::Map<const RowMajor>(
      message.weights().data(), static_cast<Eigen::Index>(vectors), message.biases_size());
  machines.biases = rowVector(message.biases());
  return Classifier(cue.kernel, std::move(machines),
                    fromMessage(message.support_vectors(), vectorForm(cue.feature)), vector_places);
}

void readNames(const proto::Model& message, Model& model) {
  model.places.assign(message.places().begin(), message.places().end());
  require(model.places.size() >= 2, "it knows fewer than two places");
  require(model.places.size() <= kMaxPlaces, "it knows too many places");
  for (std::size_t k = 0; k < model.places.size(); ++k) {
    require(isPlaceName(model.places[k]), "the name of a place is not printable UTF-8 text");
    require(k == 0 || model.places[k - 1] < model.places[k], "the names of places do not ascend");
  }
}

void readClassifiers(const proto::Model& message, Model& model) {
  const std::vector<CueOptions>& cues = model.options.cues;
  require(static_cast<std::size_t>(message.classifiers_size()) == cues.size() &&
              static_cast<std::size_t>(message.cue_weights_size()) == cues.size(),
          "it has not one classifier and one weight a cue");
  double sum = 0;
  for (const double weight : message.cue_weights()) {
    require(isShare(weight), "the weight of a cue is not in 0..1");
    sum += weight;
  }
  require(std::abs(sum - 1) < 1e-9, "the weights of the cues do not sum to one");
  model.cue_weights.assign(message.cue_weights().begin(), message.cue_weights().end());
  for (std::size_t c = 0; c < cues.size(); ++c) {
    const proto::Classifier& classifier = message.classifiers(static_cast<int>(c));
    model.classifiers.push_back(classifierFromMessage(classifier, cues[c], model));
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
  require(isShare(model.unknown_threshold), "the threshold of 'unknown' is not in 0..1");
  require(isShare(model.validation.average_rate) && isShare(model.validation.calibration_error),
          "the validation is not in 0..1");
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

/// Files of before there was such a map have none.
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

void readProvenance(const proto::Provenance& message, Model& model) {
  require(static_cast<std::size_t>(message.place_images_size()) == model.places.size(),
          "the numbers of images are not those of its places");
  Provenance& provenance = model.provenance;
  provenance.inputs.assign(message.inputs().begin(), message.inputs().end());
  provenance.place_images.assign(message.place_images().begin(), message.place_images().end());
  provenance.skipped_images = message.skipped_images();
  provenance.package_version = message.package_version();
  require(isPlaceName(provenance.package_version), "its package version is not printable text");
}

}  // namespace

proto::Model toMessage(const Model& model) {
  proto::Model message;
  message.set_options(writeOptions(model.options));
  for (const std::string& place : model.places) message.add_places(place);
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    *message.add_classifiers() =
        toMessage(model.classifiers[c], vectorForm(model.options.cues[c].feature).kind);
    message.add_cue_weights(model.cue_weights[c]);
  }
  message.set_calibration_slope(model.calibration.slope);
  const EvidenceWeights& weights = model.calibration.weights;
  append(Eigen::RowVector3d(weights.margins, weights.familiarity, weights.offset),
         message.mutable_evidence_weights());
  message.set_unknown_threshold(model.unknown_threshold);
  message.set_validation_average_rate(model.validation.average_rate);
  message.set_validation_calibration_error(model.validation.calibration_error);
  writeAdjacency(model.adjacency, message);

  proto::Provenance& provenance = *message.mutable_provenance();
  for (const std::string& input : model.provenance.inputs) provenance.add_inputs(input);
  for (const std::uint64_t count : model.provenance.place_images) {
    provenance.add_place_images(count);
  }
  provenance.set_skipped_images(model.provenance.skipped_images);
  provenance.set_package_version(model.provenance.package_version);
  return message;
}

Model fromMessage(const proto::Model& message, const std::string& where) {
  try {
    Model model;
    require(message.options().size() <= kMaxOptionsBytes, "its options are too long");
    readOptions(parseYaml(message.options(), "its configuration"), "", model.options);
    model.options.check();
    readNames(message, model);
    readClassifiers(message, model);
    readCalibration(message, model);
    readAdjacency(message, model);
    readProvenance(message.provenance(), model);
    return model;
  } catch (const Error& e) {
    throw Error("The model " + where + " cannot be used (" + e.what() +
                "); restore a backup (place_tool restore) or train the model again.");
  }
}

}  // namespace place_recognition
