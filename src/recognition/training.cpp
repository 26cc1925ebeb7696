#include "place_recognition/training.h"

#include <algorithm>
#include <chrono>
#include <string>

#include "recognition/combination.h"
#include "recognition/cue_training.h"
#include "recognition/model_validation.h"
#include "recognition/reduction_choice.h"
#include "recognition/remembered_samples.h"
#include "recognition/samples.h"

namespace place_recognition {
namespace {

Provenance provenanceOf(const Samples& samples) {
  return {samples.inputs, samples.images, samples.skipped, PLACE_RECOGNITION_VERSION};
}

/// Of each cue, with one of the reductions in question.
std::vector<HeldOut> heldOutOf(const std::vector<TrainedCue>& cues, std::size_t reduction) {
  std::vector<HeldOut> held_out;
  for (const TrainedCue& cue : cues) held_out.push_back(cue.held_out[reduction]);
  return held_out;
}

/// Warnings about places that cross-validation cannot judge.
void warnOfFewImages(const Samples& samples, int folds, std::vector<std::string>& warnings) {
  for (std::size_t k = 0; k < samples.images.size(); ++k) {
    if (samples.images[k] >= 2 * static_cast<std::uint64_t>(folds)) continue;
    warnings.push_back("The place '" + samples.places[k] + "' has only " +
                       std::to_string(samples.images[k]) +
                       " pictures; its answers and their confidence will be poor.");
  }
}

}  // namespace

std::size_t Model::supportVectorCount() const {
  std::size_t count = 0;
  for (const Classifier& classifier : classifiers) count += classifier.supportVectorCount();
  return count;
}

namespace {

/// Blocks of time, which are trained on and tested in every light that there is of them.
std::vector<Fold> foldsOf(const Samples& samples, const ValidationOptions& validation) {
  const auto recorded = static_cast<std::ptrdiff_t>(samples.recorded);
  const std::vector<SampleOrigin> origins(samples.origins.begin(),
                                          samples.origins.begin() + recorded);
  return withCopies(timeBlockFolds(origins, validation.folds, validation.gap), samples.source,
                    true);
}

/// Support vectors are the hard cases of a run: only fresh samples judge.
void judgeByFreshSamples(std::size_t remembered, std::vector<TrainedCue>& cues) {
  for (TrainedCue& cue : cues) {
    for (HeldOut& held_out : cue.held_out) {
      std::fill_n(held_out.valid.begin(), remembered, false);
    }
  }
}

/// The road from samples to a model.
Training learn(Samples samples, const TrainingOptions& options, unsigned threads,
               const Progress& progress) {
  const std::size_t places = samples.places.size();
  const std::vector<Fold> folds = foldsOf(samples, options.validation);
  const TrainingTask task{samples.origins, places, folds, options.svm, threads, progress};

  const std::vector<ReductionOptions> reductions =
      reductionsInQuestion(options.reduction, samples.origins.size());
  std::vector<TrainedCue> cues;
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    cues.push_back(trainCue(std::move(samples.features[c]), options.cues[c], reductions, task));
  }

  judgeByFreshSamples(samples.remembered, cues);

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
                                   std::move(cues[c].vectors), cues[c].vector_places);
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

  training.images = samples.recorded - samples.remembered;
  training.passed_over = samples.passed_over;
  training.warnings = samples.warnings;
  warnOfFewImages(samples, options.validation.folds, training.warnings);
  report(progress, "Calibrating", 1);
  return training;
}

/// `work()`, with the time that it took.
template <typename Work>
Training timed(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  Training training = work();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  training.seconds = elapsed.count();
  return training;
}

}  // namespace

Training train(const std::vector<RunOpener>& runs, const TrainingOptions& options, unsigned threads,
               const Progress& progress) {
  options.check();
  return timed([&] {
    return learn(collectSamples(runs, options, threads, progress), options, threads, progress);
  });
}

Training learnOn(const Model& model, const std::vector<RunOpener>& runs, int vector_limit,
                 unsigned threads, const Progress& progress) {
  TrainingOptions options = model.options;
  if (vector_limit > 0) {
    options.reduction.method = "shared-greedy";
    options.reduction.support_vectors = vector_limit;
    options.reduction.share = 0;
  }
  options.check();
  return timed([&] {
    Samples fresh = collectSamples(runs, options, threads, progress, 1);
    return learn(joinSamples(rememberedSamples(model), std::move(fresh)), options, threads,
                 progress);
  });
}

}  // namespace place_recognition
