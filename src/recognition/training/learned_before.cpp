#include "recognition/training/learned_before.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "learning/classifier_parts.h"
#include "recognition/training/combination.h"
#include "recognition/training/learning_on.h"
#include "recognition/training/model_answers.h"

namespace place_recognition {
namespace {

constexpr double kOther = -1;  // what a new machine answers to images of other places
constexpr double kOwn = 1;     // and to images of its own place
constexpr double kDistanceOfTargets = kOwn - kOther;

/// Columns of `values`, one per place of a model, where `place_of` puts them among `places`.
Eigen::MatrixXd extended(const Eigen::MatrixXd& values, const std::vector<int>& place_of,
                         std::size_t places, double others) {
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Constant(values.rows(), static_cast<Eigen::Index>(places), others);
  for (std::size_t k = 0; k < place_of.size(); ++k) {
    result.col(place_of[k]) = values.col(static_cast<Eigen::Index>(k));
  }
  return result;
}

/// How far the places of new samples have to lead the others. If the samples show all places, as
/// far as +1 is from -1, the targets of an SVM. Otherwise only so far that they are nine times as
/// probable, because more would take views from the places that the samples do not show.
double leadFor(const std::vector<int>& labels, std::size_t places, const Calibration& calibration) {
  constexpr double kMargin = 1;
  constexpr double kOdds = 9;
  if (std::set<int>(labels.begin(), labels.end()).size() == places) return kDistanceOfTargets;
  return std::min(kMargin, std::log(kOdds) / calibration.slope);
}

/// The features of the samples that are not remembered.
std::vector<std::vector<Feature>> newFeatures(const Samples& samples) {
  std::vector<std::vector<Feature>> features;
  for (const std::vector<Feature>& cue : samples.features) {
    features.emplace_back(cue.begin() + static_cast<std::ptrdiff_t>(samples.remembered), cue.end());
  }
  return features;
}

/// The places of `samples` that the model lacks.
std::vector<int> newPlaces(std::size_t places, const std::vector<int>& place_of) {
  std::vector<int> missing;
  for (int place = 0; place < static_cast<int>(places); ++place) {
    if (std::count(place_of.begin(), place_of.end(), place) == 0) missing.push_back(place);
  }
  return missing;
}

Eigen::MatrixXd changesFor(const Model& model, const Samples& samples,
                           const std::vector<int>& place_of, const std::vector<int>& new_places) {
  const CombinedValues answers =
      combine(modelAnswers(model, newFeatures(samples)), model.cue_weights, model.decision_limit);
  std::vector<int> labels;
  for (std::size_t i = samples.remembered; i < samples.origins.size(); ++i) {
    labels.push_back(samples.origins[i].place);
  }
  Eigen::MatrixXd values = extended(answers.unlimited, place_of, samples.places.size(), kOther);
  std::vector<double> leads(labels.size(),
                            leadFor(labels, samples.places.size(), model.calibration));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (std::count(new_places.begin(), new_places.end(), labels[i]) == 0) continue;
    values(static_cast<Eigen::Index>(i), labels[i]) = kOwn;
    leads[i] = kDistanceOfTargets;
  }
  Eigen::MatrixXd changes = changesToLead(values, labels, leads);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!answers.valid[i]) changes.row(static_cast<Eigen::Index>(i)).setZero();
  }
  return changes;
}

}  // namespace

LearnedBefore learnedBefore(const Model& model, const Samples& samples) {
  const std::vector<int>& place_of = samples.judged_before.front().place_of;
  const std::size_t places = samples.places.size();
  LearnedBefore learned;
  learned.new_places = newPlaces(places, place_of);
  for (const Classifier& classifier : model.classifiers) {
    const BinarySvms& before = ClassifierParts::of(classifier).machines;
    assert(!before.one_against_one);
    learned.machines.push_back({places, false, extended(before.weights, place_of, places, 0),
                                extended(before.biases, place_of, places, kOther)});
  }
  const Eigen::MatrixXd changes = changesFor(model, samples, place_of, learned.new_places);
  learned.changes.setZero(static_cast<Eigen::Index>(samples.origins.size()), changes.cols());
  learned.changes.bottomRows(changes.rows()) = changes;
  return learned;
}

}  // namespace place_recognition
