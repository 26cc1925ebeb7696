#include "experiments/place_training.h"

#include "datasets/image_recording.h"
#include "learning/gram.h"
#include "learning/selection.h"
#include "learning/support_set.h"
#include "recognition/training/cue_training.h"

namespace place_recognition {

const char* name(PlaceFeatures features) {
  return features == PlaceFeatures::kLocal ? "local" : "global";
}

TrainingOptions trainingOptions(PlaceFeatures features) {
  TrainingOptions options;
  options.image.max_width = 512;
  options.svm.c = 100;
  options.reduction.method = "none";
  CueOptions cue;
  cue.name = name(features);
  if (features == PlaceFeatures::kLocal) {
    cue.feature = LocalFeatureOptions();
    cue.kernel.type = "local-match";
  }
  options.cues = {cue};
  return options;
}

PlaceSamples::PlaceSamples(const std::vector<ImageSet>& sets, PlaceFeatures features,
                           unsigned threads, const Progress& progress)
    : options_(trainingOptions(features)), threads_(threads) {
  std::vector<RecordingOpener> recordings;
  for (const ImageSet& set : sets)
    recordings.push_back([&set] { return recordingOf(set.name, set.images); });
  samples_ = collectSamples(recordings, options_, threads, progress);
  set_samples_.place_count = static_cast<int>(samples_.places.size());
  set_samples_.set_count = static_cast<int>(sets.size());
  for (const SampleOrigin& origin : samples_.origins) {
    set_samples_.places.push_back(origin.place);
    set_samples_.sets.push_back(origin.recording);
  }
}

PlaceTraining PlaceSamples::train(const Fold& split, const Progress& progress) const {
  const std::vector<Feature>& features = samples_.features[0];
  const std::vector<SampleOrigin> origins = pick(samples_.origins, split.train);
  constexpr double kGap = 1;  // one image
  const std::vector<Fold> folds = longestBlockFolds(origins, options_.validation.folds, kGap);
  const TrainingTask task{origins, samples_.places.size(), folds, options_.svm, threads_, progress};
  CueOptions cue = options_.cues[0];
  TrainedCue trained = trainCue(pick(features, split.train), cue, {options_.reduction}, task);

  cue.kernel.gamma = trained.gamma;
  const SupportSet support_set(Kernel(cue.kernel), trained.vectors);
  report(progress, "Testing", 0);
  PlaceTraining training;
  training.gamma = trained.gamma;
  training.machines = std::move(trained.machines[0]);
  training.training_values = kernelValues(features, split.train, support_set, threads_);
  training.test_values = kernelValues(features, split.test, support_set, threads_);
  training.test = split.test;
  return training;
}

Eigen::MatrixXd PlaceSamples::measures(const Progress& progress) const {
  return measureMatrix(Kernel(options_.cues[0].kernel), samples_.features[0], threads_, progress);
}

Eigen::MatrixXd PlaceSamples::gramMatrix(const Eigen::MatrixXd& measures, double gamma) const {
  KernelOptions kernel = options_.cues[0].kernel;
  kernel.gamma = gamma;
  return place_recognition::gramMatrix(Kernel(kernel), measures);
}

}  // namespace place_recognition
