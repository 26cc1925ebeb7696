#include "place_recognition/recalibration.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/quantile.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "recognition/model/place_index.h"
#include "recognition/model/scores.h"
#include "recognition/recognizer/evidence_shift.h"
#include "recognition/training/calibration_set.h"
#include "recognition/training/combination.h"
#include "recognition/training/model_answers.h"
#include "recognition/training/model_calibration.h"
#include "recognition/training/samples.h"
#include "recognition/training/training_warnings.h"

namespace place_recognition {
namespace {

/// The frames of places that `model` knows, with the model's indices of places.
struct KnownFrames {
  std::vector<SampleOrigin> origins;
  std::vector<std::vector<Feature>> features;  // [cue]
};

KnownFrames knownFrames(const Model& model, Samples samples, std::vector<std::string>& warnings) {
  std::vector<int> place_of;
  for (std::size_t k = 0; k < samples.places.size(); ++k) {
    place_of.push_back(placeIndex(samples.places[k], model.places));
    if (place_of.back() >= 0) continue;
    warnings.push_back("The model does not know the place '" + samples.places[k] +
                       "': " + counted(samples.images[k], "image") + " left out.");
  }
  KnownFrames known;
  known.features.resize(samples.features.size());
  for (std::size_t i = 0; i < samples.origins.size(); ++i) {
    SampleOrigin origin = samples.origins[i];
    origin.place = place_of[static_cast<std::size_t>(origin.place)];
    if (origin.place < 0) continue;
    known.origins.push_back(origin);
    for (std::size_t c = 0; c < samples.features.size(); ++c) {
      known.features[c].push_back(std::move(samples.features[c][i]));
    }
  }
  return known;
}

/// The evidence of the valid frames as found by a recognizer that follows each run.
std::vector<double> evidenceOfStreams(const Model& model, const CombinedValues& combined,
                                      const std::vector<SampleOrigin>& origins) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (combined.valid[i]) order.push_back(i);
  }
  const auto when = [&](std::size_t i) {
    return std::make_tuple(origins[i].recording, origins[i].camera, origins[i].stamp);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return when(a) < when(b); });
  std::vector<double> evidence;
  EvidenceShift shift(model);
  std::pair<int, int> stream{-1, -1};
  for (const std::size_t i : order) {
    const std::pair<int, int> its{origins[i].recording, origins[i].camera};
    if (its != stream) shift.reset();
    stream = its;
    shift.beginFrame(origins[i].stamp);
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::RowVectorXd unlimited = combined.unlimited.row(row);
    const double log_odds = model.calibration.logOdds(unlimited, combined.familiarity[row]);
    evidence.push_back(logistic(log_odds + shift.value()));
    shift.add(model.calibration.probabilities(combined.decision_values.row(row)), unlimited,
              log_odds);
  }
  return evidence;
}

double fractionBelow(const std::vector<double>& values, double limit) {
  const auto below =
      std::count_if(values.begin(), values.end(), [limit](double value) { return value < limit; });
  return static_cast<double>(below) / static_cast<double>(values.size());
}

AnswerFigures figuresOf(const Model& model, const CombinedValues& combined,
                        const std::vector<SampleOrigin>& origins) {
  std::vector<int> truth, places;
  std::vector<double> confidences;
  std::vector<bool> correct;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (!combined.valid[i]) continue;
    const Eigen::RowVectorXd decision_values =
        combined.decision_values.row(static_cast<Eigen::Index>(i));
    const Eigen::RowVectorXd probabilities = model.calibration.probabilities(decision_values);
    truth.push_back(origins[i].place);
    places.push_back(largest(probabilities));
    confidences.push_back(probabilities[places.back()]);
    correct.push_back(places.back() == truth.back());
  }
  return {averageRate(truth, places, model.places.size()), calibrationError(confidences, correct),
          fractionBelow(evidenceOfStreams(model, combined, origins), model.unknown_threshold)};
}

/// Throws Error unless there are enough frames to calibrate on.
void requireEnough(const KnownFrames& frames) {
  constexpr std::size_t kFewest = 5;
  if (frames.origins.empty()) {
    throw Error("The runs show none of the places that the model knows; give one that does.");
  }
  if (frames.origins.size() >= kFewest) return;
  throw Error("The runs have only " + counted(frames.origins.size(), "usable image") +
              " of places that the model knows; give at least " + std::to_string(kFewest) + ".");
}

CombinedValues combineCues(const CalibrationSet& calibration_set, const Model& model) {
  return combine(calibration_set.reductions.front(), model.cue_weights, model.decision_limit);
}

/// Fits the model to the frames of the calibration set. Returns the figures of its answers, each
/// block of a room judged by a calibration fitted on the others.
AnswerFigures fit(const CalibrationSet& calibration_set, Model& model) {
  const std::vector<SampleOrigin>& samples = calibration_set.samples;
  const double false_alarm_rate = model.options.unknown.false_alarm_rate;
  model.cue_weights =
      chooseCueWeights(calibration_set.reductions.front(), priorWeights(model.options.cues),
                       model.decision_limit, samples, model.places.size());
  const CombinedValues combined = combineCues(calibration_set, model);
  const Calibrated calibrated = calibrate(combined, calibration_set, false_alarm_rate);
  model.calibration = calibrated.calibration;
  model.validation = calibrated.validation;
  model.held_out = keptFrames(calibration_set, 0, model.options.seed);
  model.unknown_threshold = quantile(evidenceOfStreams(model, combined, samples), false_alarm_rate);
  return {calibrated.validation.average_rate, calibrated.validation.calibration_error,
          calibrated.unknown};
}

}  // namespace

Recalibration recalibrate(Model model, const std::vector<RecordingOpener>& recordings,
                          unsigned threads, const Progress& progress) {
  TrainingOptions options = model.options;
  options.augmentation.other_light = false;
  Recalibration result;
  Samples samples = collectSamplesFor(model, recordings, options, threads, progress, 1);
  result.warnings = samples.warnings;
  for (std::size_t i = 0; i < samples.inputs.size(); ++i) {
    warnOfLearnedTest(model, samples.inputs[i], samples.sketches[i], result.warnings);
  }
  const KnownFrames frames = knownFrames(model, std::move(samples), result.warnings);
  requireEnough(frames);
  report(progress, "Calibrating", 0);
  result.images = frames.origins.size();
  const CalibrationSet calibration_set{
      frames.origins,
      longestBlockFolds(frames.origins, options.validation.folds, 0),
      {modelAnswers(model, frames.features)},
      std::vector<bool>(frames.origins.size(), true)};
  result.before = figuresOf(model, combineCues(calibration_set, model), frames.origins);
  result.after = fit(calibration_set, model);
  result.model = std::move(model);
  report(progress, "Calibrating", 1);
  return result;
}

}  // namespace place_recognition
