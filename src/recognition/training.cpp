#include "place_recognition/training.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "recognition/combination.h"
#include "recognition/cue_training.h"
#include "recognition/model_validation.h"
#include "recognition/samples.h"

namespace place_recognition {
namespace {

std::vector<std::uint64_t> countImages(const Samples& samples) {
  std::vector<std::uint64_t> counts(samples.places.size(), 0);
  for (const SampleOrigin& origin : samples.origins) ++counts[origin.place];
  return counts;
}

Provenance provenanceOf(const Samples& samples) {
  return {samples.inputs, countImages(samples), samples.skipped, PLACE_RECOGNITION_VERSION};
}

/// Warnings about places that cross-validation cannot judge.
void warnOfFewImages(const Samples& samples, int folds, std::vector<std::string>& warnings) {
  const std::vector<std::uint64_t> counts = countImages(samples);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] >= 2 * static_cast<std::uint64_t>(folds)) continue;
    warnings.push_back("The place '" + samples.places[k] + "' has only " +
                       std::to_string(counts[k]) +
                       " pictures; its answers and their confidence will be poor.");
  }
}

}  // namespace

std::size_t Model::supportVectorCount() const {
  std::size_t count = 0;
  for (const Classifier& classifier : classifiers) count += classifier.supportVectorCount();
  return count;
}

Training train(const std::vector<RunOpener>& runs, const TrainingOptions& options, unsigned threads,
               const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  options.check();
  Samples samples = collectSamples(runs, options, threads, progress);
  const std::size_t places = samples.places.size();
  const std::vector<Fold> folds =
      timeBlockFolds(samples.origins, options.validation.folds, options.validation.gap);
  const TrainingTask task{samples.origins, places, folds, options.svm, threads, progress};

  Training training;
  Model& model = training.model;
  model.options = options;
  std::vector<HeldOut> held_out;
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    TrainedCue cue =
        trainCue(std::move(samples.features[c]), options.cues[c], options.reduction, task);
    model.options.cues[c].kernel.gamma = cue.gamma;
    model.classifiers.push_back(std::move(cue.classifier));
    held_out.push_back(std::move(cue.held_out));
  }
  model.cue_weights = chooseCueWeights(held_out, samples.origins, places);

  report(progress, "Calibrating", 0);
  const Calibrated calibrated = calibrate(combine(held_out, model.cue_weights), samples.origins,
                                          folds, options.unknown.false_alarm_rate);
  model.calibration = calibrated.calibration;
  model.unknown_threshold = calibrated.unknown_threshold;
  model.validation = calibrated.validation;
  model.places = samples.places;
  model.adjacency = samples.adjacency;
  model.provenance = provenanceOf(samples);

  training.images = samples.origins.size();
  training.warnings = samples.warnings;
  warnOfFewImages(samples, options.validation.folds, training.warnings);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  training.seconds = elapsed.count();
  report(progress, "Calibrating", 1);
  return training;
}

}  // namespace place_recognition
