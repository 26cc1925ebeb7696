#include "recognition/training/model_reduction.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/quantile.h"
#include "learning/classifier_parts.h"
#include "learning/gram.h"
#include "place_recognition/error.h"
#include "recognition/model/place_index.h"
#include "recognition/model/scores.h"
#include "recognition/training/combination.h"

namespace place_recognition {
namespace {

std::vector<int> rowsWithFeature(const std::vector<Feature>& features) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!isMissing(features[i])) rows.push_back(static_cast<int>(i));
  }
  return rows;
}

/// Kernel values of all features that are not missing (rows) and the vectors (columns).
Eigen::MatrixXd kernelValuesOfAll(const std::vector<Feature>& features,
                                  const SupportSet& support_set, const Progress& progress) {
  return kernelValues(features, rowsWithFeature(features), support_set, 0, progress);
}

/// Mean over all support vectors of the largest kernel value against another one in `kept`.
double meanFamiliarity(const Eigen::MatrixXd& kernel_values, const std::vector<int>& kept) {
  double sum = 0;
  for (Eigen::Index i = 0; i < kernel_values.rows(); ++i) {
    double largest = 0;
    for (const int j : kept) {
      if (j != i) largest = std::max(largest, kernel_values(i, j));
    }
    sum += largest;
  }
  return kernel_values.rows() > 0 ? sum / static_cast<double>(kernel_values.rows()) : 0;
}

/// By how much frames look less familiar to the vectors that `machines` use than to all vectors.
double familiarityLost(const Classifier& classifier, const BinarySvms& machines) {
  const auto& [used, support_set, origins] = ClassifierParts::of(classifier);
  const Eigen::MatrixXd values = kernelValuesOfAll(support_set.vectors(), support_set, {});
  return meanFamiliarity(values, supportVectors(used)) -
         meanFamiliarity(values, supportVectors(machines));
}

}  // namespace

ModelReduction::ModelReduction(const Model& model, const Samples* training,
                               const Progress& progress)
    : model_(model) {
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    const SupportSet& support_set = ClassifierParts::of(model.classifiers[c]).support_set;
    const std::vector<Feature> own = training ? std::vector<Feature>() : support_set.vectors();
    const std::vector<Feature>& rows = training ? training->features[c] : own;
    kernel_values_.push_back(kernelValuesOfAll(rows, support_set, progress));
  }
}

std::vector<BinarySvms> ModelReduction::reduce(const ReductionOptions& options,
                                               const Progress& progress) const {
  std::vector<BinarySvms> reduced;
  for (std::size_t c = 0; c < model_.classifiers.size(); ++c) {
    reduced.push_back(place_recognition::reduce(ClassifierParts::of(model_.classifiers[c]).machines,
                                                kernel_values_[c], options, progress));
  }
  return reduced;
}

std::vector<std::unique_ptr<const Reduction>> ModelReduction::factorize(
    const ReductionOptions& options, const Progress& progress) const {
  std::vector<std::unique_ptr<const Reduction>> reductions;
  for (std::size_t c = 0; c < model_.classifiers.size(); ++c) {
    reductions.push_back(place_recognition::factorize(
        ClassifierParts::of(model_.classifiers[c]).machines, kernel_values_[c], options, progress));
  }
  return reductions;
}

DecisionValueChange ModelReduction::change(const std::vector<BinarySvms>& machines) const {
  DecisionValueChange result;
  double sum = 0;
  double count = 0;
  for (std::size_t c = 0; c < machines.size(); ++c) {
    const Eigen::MatrixXd& values = kernel_values_[c];
    const Eigen::MatrixXd before =
        ClassifierParts::of(model_.classifiers[c]).machines.decisionValues(values);
    const Eigen::ArrayXXd change = (machines[c].decisionValues(values) - before).array().abs();
    if (change.size() > 0) result.largest = std::max(result.largest, change.maxCoeff());
    sum += change.sum();
    count += static_cast<double>(change.size());
  }
  result.mean = count > 0 ? sum / count : 0;
  return result;
}

RateOnSamples::RateOnSamples(const Model& model, const Samples& samples, const Progress& progress)
    : model_(model) {
  std::vector<int> index_in_model;
  for (const std::string& place : samples.places) {
    index_in_model.push_back(placeIndex(place, model.places));
    if (index_in_model.back() < 0) {
      throw Error("The model does not know the place '" + place +
                  "' in the validation runs; give runs of the places that it knows.");
    }
  }
  for (const SampleOrigin& origin : samples.origins) truth_.push_back(index_in_model[origin.place]);
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    rows_.push_back(rowsWithFeature(samples.features[c]));
    kernel_values_.push_back(kernelValues(samples.features[c], rows_[c],
                                          ClassifierParts::of(model.classifiers[c]).support_set, 0,
                                          progress));
  }
}

double RateOnSamples::operator()(const std::vector<BinarySvms>& machines) const {
  constexpr double kUnused = 0;  // familiarity, which does not decide between places
  std::vector<HeldOutValues> cues;
  for (std::size_t c = 0; c < machines.size(); ++c) {
    const Eigen::MatrixXd decision_values =
        placeValues(machines[c], machines[c].decisionValues(kernel_values_[c]));
    HeldOutValues& cue =
        cues.emplace_back(HeldOutValues::none(truth_.size(), model_.places.size()));
    for (std::size_t i = 0; i < rows_[c].size(); ++i) {
      cue.set(rows_[c][i], decision_values.row(static_cast<Eigen::Index>(i)), kUnused);
    }
  }
  const HeldOutValues combined = combine(cues, model_.cue_weights, model_.decision_limit);
  std::vector<int> answers(truth_.size(), -1);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (!combined.valid[i]) continue;
    answers[i] = largest(model_.calibration.probabilities(combined.decision_values.row(row)));
  }
  return averageRate(truth_, answers, model_.places.size());
}

std::vector<BinarySvms> machinesOf(const Model& model) {
  std::vector<BinarySvms> machines;
  for (const Classifier& classifier : model.classifiers) {
    machines.push_back(ClassifierParts::of(classifier).machines);
  };
  return machines;
}

Model withMachines(Model model, std::vector<BinarySvms> machines, const ReductionOptions& options) {
  model.options.reduction = options;
  model.validation = {};  // was of other machines
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    model.calibration.weights.offset += model.calibration.weights.familiarity *
                                        model.cue_weights[c] *
                                        familiarityLost(model.classifiers[c], machines[c]);
    std::vector<Feature> vectors = ClassifierParts::of(model.classifiers[c]).support_set.vectors();
    const std::vector<VectorOrigin> origins = ClassifierParts::of(model.classifiers[c]).origins;
    model.classifiers[c] = ClassifierParts::assemble(
        model.options.cues[c].kernel, std::move(machines[c]), std::move(vectors), origins);
  }
  return model;
}

double comparisonMilliseconds(const Model& model,
                              const std::vector<std::vector<Feature>>& features) {
  constexpr std::size_t kImages = 200;
  using Clock = std::chrono::steady_clock;
  Eigen::VectorXd kernel_values;
  Eigen::RowVectorXd decision_values;
  std::vector<double> milliseconds;
  for (std::size_t i = 0; i < std::min(kImages, features[0].size()); ++i) {
    const Clock::time_point start = Clock::now();
    for (std::size_t c = 0; c < features.size(); ++c) {
      if (i >= features[c].size() || isMissing(features[c][i])) continue;
      model.classifiers[c].decisionValues(features[c][i], kernel_values, decision_values);
    }
    milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  return median(std::move(milliseconds));
}

}  // namespace place_recognition
