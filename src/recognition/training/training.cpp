#include "place_recognition/training.h"

#include <algorithm>
#include <chrono>
#include <functional>
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

/// What incremental training keeps of the model before.
struct Kept {
  double forgetting = 0;                      ///< see IncrementalOptions
  std::optional<LearnedBefore> learned = {};  ///< what to extend, if anything
  std::vector<double> cue_weights = {};       ///< empty: to be found
};

/// Trains every cue on the features of `samples`, which are moved from.
std::vector<TrainedCue> trainCues(Samples& samples, const std::vector<CueOptions>& options,
                                  const std::vector<ReductionOptions>& reductions,
                                  const std::optional<LearnedBefore>& learned, TrainingTask task) {
  std::vector<TrainedCue> cues;
  for (std::size_t c = 0; c < options.size(); ++c) {
    if (learned) {
      task.learned.emplace(LearnedCue{learned->machines[c], learned->changes, learned->new_places});
    }
    cues.push_back(trainCue(std::move(samples.features[c]), options[c], reductions, task));
  }
  return cues;
}

/// The cues together after each reduction.
std::vector<CombinedValues> combineEach(const CalibrationSet& calibration_set, const Model& model) {
  std::vector<CombinedValues> combined;
  for (const std::vector<HeldOutValues>& cues : calibration_set.reductions) {
    combined.push_back(combine(cues, model.cue_weights, model.decision_limit));
  }
  return combined;
}

/// Gives the model the classifiers of the cues after one of the reductions.
void assemble(std::vector<TrainedCue> cues, std::size_t reduction, Training& training) {
  for (std::size_t c = 0; c < cues.size(); ++c) {
    KernelOptions& kernel = training.model.options.cues[c].kernel;
    kernel.gamma = cues[c].gamma;
    training.unreduced_vectors.push_back(cues[c].vectors.size());
    training.model.classifiers.push_back(
        ClassifierParts::assemble(kernel, std::move(cues[c].machines[reduction]),
                                  std::move(cues[c].vectors), cues[c].origins));
  }
}

/// Gives the model the probabilities of its answers. `held_out`: after the chosen reduction.
void calibrateModel(const CombinedValues& held_out, const CalibrationSet& calibration_set,
                    std::size_t reduction, Model& model) {
  const Calibrated calibrated =
      calibrate(held_out, calibration_set, model.options.unknown.false_alarm_rate);
  model.held_out = keptFrames(calibration_set, reduction, model.options.seed);
  model.calibration = calibrated.calibration;
  model.unknown_threshold = calibrated.unknown_threshold;
  model.validation = calibrated.validation;
}

/// Gives the model what the samples tell besides their features.
void describe(const Samples& samples, Model& model) {
  model.places = samples.places;
  model.images = samples.image_profile;
  if (followsLight(model.options)) model.colours = colourStatistics(samples.colours);
  model.adjacency = samples.adjacency;
  model.provenance = {samples.inputs, samples.images, samples.skipped, PLACE_RECOGNITION_VERSION,
                      samples.sketches};
}

/// What the samples and the held-out answers give reason to warn of.
std::vector<std::string> warningsOf(const Samples& samples, const CombinedValues& held_out,
                                    const CalibrationSet& calibration_set, int folds) {
  std::vector<std::string> warnings = samples.warnings;
  warnOfFewImages(samples, folds, warnings);
  warnOfConfusedPairs(confusedPairs(held_out, calibration_set.samples, samples.places.size()),
                      samples.places, warnings);
  for (std::string& warning : warnOfLikeNames(samples.places)) {
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

/// The steps from samples to a model, whose options are the requested ones and those found.
Training learn(Samples samples, TrainingOptions options, const Kept& kept, unsigned threads,
               const Progress& progress) {
  const std::size_t places = samples.places.size();
  report(progress, "Choosing blocks of time", 0);
  std::vector<Fold> folds = chooseFolds(samples, threads, options);
  if (kept.learned) folds = withRemembered(std::move(folds), samples.remembered);
  const std::vector<ReductionOptions> reductions =
      reductionsInQuestion(options.reduction, samples.origins.size());
  const TrainingTask task{samples.origins, places,   folds,        options.svm,
                          threads,         progress, options.seed, kept.forgetting};
  std::vector<TrainedCue> cues = trainCues(samples, options.cues, reductions, kept.learned, task);
  CalibrationSet calibration_set = calibrationSetOf(samples, folds, cues, reductions.size());
  if (!kept.cue_weights.empty()) keepWhatIsUnknown(samples.origins.size(), calibration_set);

  Training training;
  Model& model = training.model;
  model.options = options;
  model.decision_limit = decisionLimit(options);
  model.cue_weights = kept.cue_weights;
  if (model.cue_weights.empty()) {
    model.cue_weights = chooseCueWeights(calibration_set.reductions[0], priorWeights(options.cues),
                                         model.decision_limit, calibration_set.samples, places);
  }
  const std::vector<CombinedValues> held_out = combineEach(calibration_set, model);
  const std::size_t chosen = chooseReduction(reductions, held_out, calibration_set.samples, places);
  model.options.reduction = reductions[chosen];
  assemble(std::move(cues), chosen, training);

  report(progress, "Calibrating", 0);
  calibrateModel(held_out[chosen], calibration_set, chosen, model);
  describe(samples, model);
  model.cameras = learnCameraCorrelation(samples.cameras, samples.recordedOrigins(),
                                         held_out[chosen], model.calibration);
  training.images = samples.recorded - samples.remembered;
  training.passed_over = samples.passed_over;
  training.warnings =
      warningsOf(samples, held_out[chosen], calibration_set, options.validation.folds);
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

/// The most new images, so that the Gram matrices, which include the remembered vectors, hardly
/// become larger than in a training of `most` images.
int mostNewImages(const Samples& remembered, int most) {
  constexpr int kAlways = 1000;
  std::ptrdiff_t vectors = 0;
  for (const std::vector<Feature>& cue : remembered.features) {
    vectors = std::max(vectors, std::count_if(cue.begin(), cue.end(), std::not_fn(isMissing)));
  }
  return std::max(std::min(most, kAlways), most - static_cast<int>(vectors));
}

}  // namespace

Training train(const std::vector<RecordingOpener>& recordings, const TrainingOptions& options,
               unsigned threads, const Progress& progress, const AfterReading& after_reading) {
  options.check();
  return timed([&] {
    const TrainingOptions ready = withMirror(withNetworks(options), recordings);
    Samples samples = collectSamples(recordings, ready, threads, progress);
    if (after_reading) after_reading(samples.sketches, samples.image_profile.levels);
    Training training = learn(std::move(samples), ready, {}, threads, progress);
    training.model.asked = options;
    return training;
  });
}

Training trainIncrementally(const Model& model, const std::vector<RecordingOpener>& recordings,
                            const IncrementalOptions& incremental, unsigned threads,
                            const Progress& progress, const AfterReading& after_reading) {
  if (incremental.vector_limit < 0 ||
      !(incremental.forgetting >= 0 && incremental.forgetting <= 1)) {
    throw Error("The vector limit is below 0, or forgetting is not within 0..1; correct it.");
  }
  if (incremental.other) requireJoinable(model, *incremental.other);
  TrainingOptions options = model.asked;
  options.image = model.options.image;
  options.cues = model.options.cues;
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
      TrainingOptions sampled = options;
      sampled.sampling.most = mostNewImages(samples, options.sampling.most);
      Samples fresh = collectSamplesFor(model, recordings, sampled, threads, progress, 1);
      warnOfLearnedRuns(model, fresh, fresh.warnings);
      samples = joinSamples(std::move(samples), std::move(fresh));
    }
    if (after_reading) after_reading(samples.sketches, samples.image_profile.levels);
    if (samples.origins.empty()) {
      throw Error("The models have no support vectors, and no images are added; add images.");
    }
    Kept kept{incremental.forgetting};
    if (canLearnOn(model, samples, incremental)) kept.learned = learnedBefore(model, samples);
    if (!incremental.other) kept.cue_weights = model.cue_weights;
    Training training = learn(std::move(samples), options, kept, threads, progress);
    warnOfTightLimit(model, incremental.vector_limit, training.warnings);
    training.model.asked = model.asked;
    if (!training.model.cameras.known()) training.model.cameras = model.cameras;
    return training;
  });
}

}  // namespace place_recognition
