#include "tuning/tuning_samples.h"

#include <algorithm>
#include <utility>

#include "base/place_name.h"
#include "recognition/training/block_choice.h"
#include "tuning/next_run.h"
#include "tuning/thinned_recording.h"

namespace place_recognition {
namespace {

/// `opened` counts the recordings that have been opened.
std::vector<RecordingOpener> thinnedOpeners(const TuningRecordings& recordings, std::size_t step,
                                            std::uint64_t seed, std::size_t& opened) {
  constexpr std::uint64_t kSeedsOfRecording = kMaxPlaces;  // one seed per place
  std::vector<RecordingOpener> openers;
  for (const std::vector<RecordingOpener>* group : {&recordings.recordings, &recordings.hold_out}) {
    for (const RecordingOpener& open : *group) {
      const std::uint64_t run_seed = seed + kSeedsOfRecording * openers.size();
      openers.push_back([open, step, run_seed, &opened] {
        ++opened;
        return thinOut(open(), step, run_seed);
      });
    }
  }
  return openers;
}

/// The progress of reading one of several recordings as a fraction of the whole.
Progress partOf(const Progress& whole, std::size_t recordings, const std::size_t& opened) {
  return [&whole, recordings, &opened](const std::string&, double fraction) {
    const double done = static_cast<double>(opened) - 1 + fraction;
    return !whole || whole("Extracting features", done / static_cast<double>(recordings));
  };
}

/// Folds over the recorded samples.
std::vector<Fold> recordedFolds(const Samples& samples, const TuningRecordings& recordings,
                                const TrainingOptions& options, unsigned threads) {
  const std::vector<SampleOrigin> origins = samples.recordedOrigins();
  if (!recordings.hold_out.empty()) {
    Fold fold;
    for (std::size_t i = 0; i < origins.size(); ++i) {
      const bool trained_on = origins[i].recording < static_cast<int>(recordings.recordings.size());
      (trained_on ? fold.train : fold.test).push_back(static_cast<int>(i));
    }
    return {fold};
  }
  const int complete = completeRecordings(origins);
  if (complete >= 2) {
    const int count = std::min(complete, options.validation.folds);
    return timeBlockFolds(origins, count, {});
  }
  return timeBlockFolds(
      origins, options.validation.folds,
      chooseBlocks(origins, samples.features, options.cues, options.validation, threads));
}

}  // namespace

TuningSamples collectTuningSamples(const TuningRecordings& recordings,
                                   const TrainingOptions& options, bool other_light,
                                   std::size_t step, unsigned threads, const Progress& progress) {
  std::size_t opened = 0;
  const std::vector<RecordingOpener> openers =
      thinnedOpeners(recordings, step, options.seed, opened);
  NextRun next_run(options.seed, other_light);
  const ImageChange change = [&next_run](const cv::Mat& image, const std::string& place) {
    return next_run.change(image, place);
  };
  TuningSamples samples{
      collectSamples(openers, options, threads, partOf(progress, openers.size(), opened), 2,
                     recordings.images, change),
      {}};
  // Frames are missing at the borders of parts, so that some would be joined and others not.
  for (SampleOrigin& origin : samples.origins) origin.recording = origin.part;
  samples.folds =
      withCopies(recordedFolds(samples, recordings, options, threads), samples.source, false);
  return samples;
}

}  // namespace place_recognition
