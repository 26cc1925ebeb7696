#include "place_recognition/training.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "recognition/combination.h"
#include "recognition/cue_training.h"
#include "recognition/model_validation.h"
#include "recognition/reduction_choice.h"
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

/// Of each cue, with one of the reductions in question.
std::vector<HeldOut> heldOutOf(const std::vector<TrainedCue>& cues, std::size_t reduction) {
  std::vector<HeldOut> held_out;
  for (const TrainedCue& cue : cues) held_out.push_back(cue.held_out[reduction]);
  return held_out;
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

  const std::vector<ReductionOptions> reductions = reductionsInQuestion(options.reduction);
  std::vector<TrainedCue> cues;
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    cues.push_back(trainCue(std::move(samples.features[c]), options.cues[c], reductions, task));
  }

  Training training;
  Model& model = training.model;
  model.options = options;
  model.cue_weights = chooseCueWeights(heldOutOf(cues, 0), samples.origins, places);
  std::vector<HeldOut> held_out;
  for (std::size_t r = 0; r < reductions.size(); ++r) {
    held_out.push_back(combine(heldOutOf(cues, r), model.cue_weights));
  }
  const std::size_t chosen = chooseReduction(reductions, held_out, samples.origins, places);
  model.options.reduction = reductions[chosen];
  for (std::size_t c = 0; c < cues.size(); ++c) {
    KernelOptions& kernel = model.options.cues[c].kernel;
    kernel.gamma = cues[c].gamma;
    training.unreduced_vectors.push_back(cues[c].vectors.size());
    model.classifiers.emplace_back(kernel, std::move(cues[c].machines[chosen]),
                                   std::move(cues[c].vectors));
  }

  report(progress, "Calibrating", 0);
  const Calibrated calibrated =
      calibrate(held_out[chosen], samples.origins, folds, options.unknown.false_alarm_rate);
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
