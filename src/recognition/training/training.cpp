#include "place_recognition/training.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <string>

#include "base/place_name.h"
#include "base/text.h"
#include "learning/classifier_parts.h"
#include "place_recognition/error.h"
#include "recognition/frames/colour_normalization.h"
#include "recognition/frames/mirror_search.h"
#include "recognition/model/embeddings.h"
#include "recognition/training/calibration_set.h"
#include "recognition/training/camera_correlation_training.h"
#include "recognition/training/combination.h"
#include "recognition/training/cue_training.h"
#include "recognition/training/learned_before.h"
#include "recognition/training/model_calibration.h"
#include "recognition/training/reduction_choice.h"
#include "recognition/training/remembered_samples.h"
#include "recognition/training/samples.h"
#include "recognition/training/training_folds.h"
#include "recognition/training/training_warnings.h"

namespace place_recognition {
namespace {

Provenance provenanceOf(const Samples& samples) {
  return {samples.inputs, samples.images, samples.skipped, PLACE_RECOGNITION_VERSION};
}

/// Whether the light of a recording is compared with that of the training.
bool followsLight(const TrainingOptions& options) {
  return std::any_of(options.cues.begin(), options.cues.end(), [](const CueOptions& cue) {
    return colourNormalization(cue.normalize) == ColourNormalization::kRun;
  });
}

/// Held-out decision values of the samples, and of the frames on which earlier models of the
/// remembered samples were validated.
CalibrationSet calibrationSetOf(const Samples& samples, const std::vector<Fold>& folds,
                                std::vector<TrainedCue>& cues, std::size_t reductions) {
  CalibrationSet calibration_set{
      samples.origins, {}, {}, std::vector<bool>(samples.origins.size(), true)};
  for (const Fold& fold : folds) calibration_set.folds.push_back({{}, fold.test});
  for (std::size_t r = 0; r < reductions; ++r) {
    std::vector<HeldOutValues>& held_out = calibration_set.reductions.emplace_back();
    for (TrainedCue& cue : cues) held_out.push_back(std::move(cue.held_out[r]));
  }
  for (const JudgedBefore& before : samples.judged_before) {
    calibration_set.add(before.frames, before.place_of, samples.remembered);
  }
  // Support vectors are the hard cases of a recording, so they are not used for validation.
  for (std::vector<HeldOutValues>& held_out : calibration_set.reductions) {
    for (HeldOutValues& cue : held_out) std::fill_n(cue.valid.begin(), samples.remembered, false);
  }
  return calibration_set;
}

/// Leaves what is 'unknown' to the frames that judged the model before, and to samples of places
/// that these do not show: else 5 % of samples in another light would be 'unknown', and hardly any
/// frame in the light of before. `count`: of the samples in front of those frames.
void keepWhatIsUnknown(std::size_t count, CalibrationSet& calibration_set) {
  const std::vector<SampleOrigin>& samples = calibration_set.samples;
  std::set<int> judged;
  for (std::size_t i = count; i < samples.size(); ++i) judged.insert(samples[i].place);
  for (std::size_t i = 0; i < count; ++i) {
    calibration_set.judges_unknown[i] = judged.count(samples[i].place) == 0;
  }
}

/// The steps from samples to a model, whose options are the requested ones and those found.
/// `learned`: what to extend, if anything. `kept_weights`: of the cues; empty: to be found.
Training learn(Samples samples, TrainingOptions options, double forgetting, unsigned threads,
               const Progress& progress, const std::optional<LearnedBefore>& learned = {},
               const std::vector<double>& kept_weights = {}) {
  const std::size_t places = samples.places.size();
  report(progress, "Choosing blocks of time", 0);
  std::vector<Fold> folds = chooseFolds(samples, threads, options);
  if (learned) folds = withRemembered(std::move(folds), samples.remembered);
  const TrainingTask task{samples.origins, places,   folds,        options.svm,
                          threads,         progress, options.seed, forgetting};

  const std::vector<ReductionOptions> reductions =
      reductionsInQuestion(options.reduction, samples.origins.size());
  std::vector<TrainedCue> cues;
  for (std::size_t c = 0; c < options.cues.size(); ++c) {
    TrainingTask task_of_cue = task;
    if (learned) {
      task_of_cue.learned.emplace(
          LearnedCue{learned->machines[c], learned->changes, learned->new_places});
    }
    cues.push_back(
        trainCue(std::move(samples.features[c]), options.cues[c], reductions, task_of_cue));
  }

  CalibrationSet calibration_set = calibrationSetOf(samples, folds, cues, reductions.size());
  if (!kept_weights.empty()) keepWhatIsUnknown(samples.origins.size(), calibration_set);

  Training training;
  Model& model = training.model;
  model.options = options;
  model.decision_limit = decisionLimit(options);
  model.cue_weights =
      !kept_weights.empty()
          ? kept_weights
          : chooseCueWeights(calibration_set.reductions[0], priorWeights(options.cues),
                             model.decision_limit, calibration_set.samples, places);
  std::vector<CombinedValues> held_out;
  for (const std::vector<HeldOutValues>& reduced : calibration_set.reductions) {
    held_out.push_back(combine(reduced, model.cue_weights, model.decision_limit));
  }
  const std::size_t chosen = chooseReduction(reductions, held_out, calibration_set.samples, places);
  model.options.reduction = reductions[chosen];
  for (std::size_t c = 0; c < cues.size(); ++c) {
    KernelOptions& kernel = model.options.cues[c].kernel;
    kernel.gamma = cues[c].gamma;
    training.unreduced_vectors.push_back(cues[c].vectors.size());
    model.classifiers.push_back(ClassifierParts::assemble(
        kernel, std::move(cues[c].machines[chosen]), std::move(cues[c].vectors), cues[c].origins));
  }

  report(progress, "Calibrating", 0);
  const Calibrated calibrated =
      calibrate(held_out[chosen], calibration_set, options.unknown.false_alarm_rate);
  model.held_out = keptFrames(calibration_set, chosen, options.seed);
  model.calibration = calibrated.calibration;
  model.unknown_threshold = calibrated.unknown_threshold;
  model.validation = calibrated.validation;
  model.places = samples.places;
  model.images = samples.image_profile;
  if (followsLight(options)) model.colours = colourStatistics(samples.colours);
  model.adjacency = samples.adjacency;
  model.cameras = learnCameraCorrelation(samples.cameras, samples.recordedOrigins(),
                                         held_out[chosen], model.calibration);
  model.provenance = provenanceOf(samples);

  training.images = samples.recorded - samples.remembered;
  training.passed_over = samples.passed_over;
  training.warnings = samples.warnings;
  warnOfFewImages(samples, options.validation.folds, training.warnings);
  warnOfConfusedPairs(confusedPairs(held_out[chosen], calibration_set.samples, places),
                      model.places, training.warnings);
  for (std::string& warning : warnOfLikeNames(model.places)) {
    training.warnings.push_back(std::move(warning));
  }
  report(progress, "Calibrating", 1);
  return training;
}

/// Calls `work()` and adds the time it took.
template <typename Work>
Training timed(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  Training training = work();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  training.seconds = elapsed.count();
  return training;
}

/// Whether the machines of `model` are extended. They are not if they are one-against-one, when
/// joined with another model, nor with a vector limit, which would remove vectors from them again.
/// The time that learnOn() takes grows with the third power of the number of vectors and samples.
/// Otherwise support vectors and samples are trained on together.
bool canLearnOn(const Model& model, const Samples& samples, const IncrementalOptions& options) {
  constexpr std::size_t kMaxRows = 3000;
  const std::size_t fresh = samples.origins.size() - samples.remembered;
  if (options.other || options.vector_limit > 0 || fresh == 0) return false;
  if (model.options.svm.multiclass == "one-against-one") return false;
  return std::all_of(model.classifiers.begin(), model.classifiers.end(),
                     [fresh](const Classifier& classifier) {
                       return classifier.supportVectorCount() + fresh <= kMaxRows;
                     });
}

/// A fraction would be taken of the remainder of earlier runs again and again, and the few new
/// frames cannot determine one.
ReductionOptions learningOnReduction(ReductionOptions asked, int vector_limit) {
  if (vector_limit > 0) {
    asked.method = "shared-greedy";
    asked.support_vectors = vector_limit;
    asked.share = 0;
  } else if (asked.method == "auto" || asked.share > 0) {
    asked.method = "none";
    asked.share = 0;
  }
  return asked;
}

/// The most new images, so that the Gram matrices, which include the vectors of the model, hardly
/// become larger than in a training of `most` images.
int mostNewImages(const Model& model, int most) {
  constexpr int kAlways = 1000;
  std::size_t vectors = 0;
  for (const Classifier& classifier : model.classifiers) {
    vectors = std::max(vectors, classifier.supportVectorCount());
  }
  return std::max(std::min(most, kAlways), most - static_cast<int>(vectors));
}

}  // namespace

Training train(const std::vector<RecordingOpener>& recordings, const TrainingOptions& options,
               unsigned threads, const Progress& progress) {
  options.check();
  return timed([&] {
    const TrainingOptions ready = withMirror(withNetworks(options), recordings);
    Training training =
        learn(collectSamples(recordings, ready, threads, progress), ready, 0, threads, progress);
    training.model.asked = options;
    return training;
  });
}

Training trainIncrementally(const Model& model, const std::vector<RecordingOpener>& recordings,
                            const IncrementalOptions& incremental, unsigned threads,
                            const Progress& progress) {
  if (incremental.vector_limit < 0 ||
      !(incremental.forgetting >= 0 && incremental.forgetting <= 1)) {
    throw Error("The vector limit is below 0, or forgetting is not within 0..1; correct it.");
  }
  if (incremental.other) requireJoinable(model, *incremental.other);
  TrainingOptions options = model.asked;
  options.image = model.options.image;
  options.cues = model.options.cues;
  options.sampling.most = mostNewImages(model, options.sampling.most);
  options.reduction = learningOnReduction(options.reduction, incremental.vector_limit);
  options.check();
  return timed([&] {
    Samples samples = rememberedSamples(model);
    if (incremental.other) {
      samples = joinSamples(std::move(samples), rememberedSamples(*incremental.other));
    }
    if (recordings.empty()) {
      options.validation = model.options.validation;  // there are no new frames for validation
    } else {
      Samples fresh = collectSamplesFor(model, recordings, options, threads, progress, 1);
      warnOfLearnedRuns(model, fresh.inputs, fresh.warnings);
      samples = joinSamples(std::move(samples), std::move(fresh));
    }
    if (samples.origins.empty()) {
      throw Error("The models have no support vectors, and no images are added; add images.");
    }
    std::optional<LearnedBefore> learned;
    if (canLearnOn(model, samples, incremental)) learned = learnedBefore(model, samples);
    Training training =
        learn(std::move(samples), options, incremental.forgetting, threads, progress, learned,
              incremental.other ? std::vector<double>() : model.cue_weights);
    warnOfTightLimit(model, incremental.vector_limit, training.warnings);
    training.model.asked = model.asked;
    if (!training.model.cameras.known()) training.model.cameras = model.cameras;
    return training;
  });
}

}  // namespace place_recognition
