#include "recognition/training/frame_collection.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/place_name.h"
#include "place_recognition/error.h"
#include "recognition/frames/continuity.h"
#include "recognition/frames/image_guard.h"
#include "recognition/frames/image_hash.h"
#include "recognition/frames/light.h"
#include "recognition/training/labelled_light.h"
#include "recognition/training/repeated_images.h"
#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

/// One camera during a recording.
struct CameraStream {
  int number;  // index into FrameCollection::cameras
  ImageGuard guard;
  FrameRate rate;
  LabelledLight light;
  std::map<std::string, int> frames;  // of each place so far
};

void requirePlaceName(const Frame& frame) {
  const std::string why_not = frame.place.empty() ? "" : whyNoPlaceName(frame.place);
  if (!why_not.empty()) {
    throw Error("The label '" + frame.place + "' of " + frame.name + " " + why_not);
  }
}

class Collector {
 public:
  Collector(const TrainingOptions& options, const ImageProfile& profile, const Model* model,
            const ImageChange& change, std::size_t most, unsigned threads)
      : image_options_(options.image),
        rate_(options.sampling.rate),
        expected_(profile),
        model_(model),
        change_(change),
        most_(most),
        collected_(profile, options.seed),
        pool_(options, profile, threads) {}

  void read(Recording& recording, const Progress& progress) {
    collected_.inputs.push_back(recording.name());
    collected_.sketches.emplace_back();
    collected_.left_out.emplace_back();
    if (collected_.how_to_label.empty()) collected_.how_to_label = recording.howToLabel();
    recording.setLevelRange(expected_.levels);
    std::vector<CameraStream> streams = streamsOf(recording);
    Continuity before = continuity_;  // until the first image that is not repeated
    before.begin(recording.cameras());
    std::uint64_t images = 0, fresh = 0;
    const std::string stage = "Reading " + recording.name();
    report(progress, stage, 0);
    for (Frame frame; recording.next(frame); report(progress, stage, recording.fraction())) {
      if (images++ == 0) {
        before.beginsStream(frame);
        repeated_.begin(recording.name(), before.continues());
      }
      if (isRepeated(frame)) continue;
      if (fresh++ == 0) continuity_.begin(recording.cameras());
      if (continuity_.beginsStream(frame)) {
        streams_ = std::move(streams);
        collected_.seen.emplace_back();
      }
      take(frame, streams_[static_cast<std::size_t>(frame.camera)]);
    }
    if (fresh < images) collected_.warnings.push_back(repeated_.sentence());
    collected_.warnings.insert(collected_.warnings.end(), recording.warnings().begin(),
                               recording.warnings().end());
  }

  FrameCollection finish() {
    pool_.finish();
    dropFeatureless();
    return std::move(collected_);
  }

 private:
  std::vector<CameraStream> streamsOf(const Recording& recording) {
    std::vector<CameraStream> streams;
    std::vector<std::string>& cameras = collected_.cameras;
    for (const std::string& camera : recording.cameras()) {
      if (!isUtf8(camera)) {
        throw Error("A topic of images in " + recording.name() + " is not UTF-8 text; rename it.");
      }
      const auto known = std::find(cameras.begin(), cameras.end(), camera);
      streams.push_back({static_cast<int>(known - cameras.begin()),
                         ImageGuard(expected_, image_options_, ImageGuard::Use::kTraining),
                         FrameRate(rate_),
                         LabelledLight(model_),
                         {}});
      if (known == cameras.end()) cameras.push_back(camera);
    }
    return streams;
  }

  /// Whether the training goes on as if the frame did not exist. Its image counts for the sketch.
  bool isRepeated(const Frame& frame) {
    ++collected_.images;
    requirePlaceName(frame);
    const std::optional<std::uint64_t> hash = imageHash(frame.image);
    const bool labelled = !frame.place.empty();
    if (hash && labelled) collected_.sketches.back().add(*hash);
    return repeated_.isRepeated(hash, labelled);
  }

  void take(const Frame& frame, CameraStream& camera) {
    collected_.seen.back().push_back({frame.stamp, frame.place});
    if (collected_.left_out.back().leavesOut(frame)) return;
    if (!camera.rate.admits(frame.stamp)) {
      ++collected_.passed_over;
      return;
    }
    const int number = camera.frames[frame.place]++;
    const std::optional<int> level = collected_.sample.next(frame.place);
    if (!level) return;
    for (const std::string& warning : camera.guard.judge(frame.image, frame.stamp)) {
      collected_.warnings.push_back(collected_.inputs.back() + ": " + warning);
    }
    include(statisticsOf(frame.image), collected_.profile);
    add(frame, camera, number, *level);
    if (collected_.frames.size() > 2 * most_) dropHalf();
  }

  void add(const Frame& frame, CameraStream& camera, int number, int level) {
    CollectedFrame& added = collected_.frames.emplace_back();
    added.place = frame.place;
    added.recording = static_cast<int>(collected_.seen.size()) - 1;
    added.part = static_cast<int>(collected_.inputs.size()) - 1;
    added.stamp = frame.stamp;
    added.camera = camera.number;
    added.number = number;
    added.name = frame.name;
    added.level = level;
    const Light light = camera.light.next(frame);
    pool_.submit(frame.image, added.extracted, light);
    if (!change_) return;
    const ChangedImage changed = change_(frame.image, frame.place);
    pool_.submit(changed.image, added.changed, light * changed.correction);
  }

  /// Keeps memory bounded.
  void dropHalf() {
    pool_.finish();
    dropFeatureless();
    collected_.sample.halve();
    drop([this](const CollectedFrame& frame) {
      return !collected_.sample.keeps(frame.place, frame.level);
    });
  }

  void dropFeatureless() {
    drop([this](const CollectedFrame& frame) {
      if (frame.hasFeature()) return false;
      collected_.left_out[static_cast<std::size_t>(frame.part)].add(frame.place, frame.name,
                                                                    frame.extracted.problem);
      return true;
    });
  }

  template <typename Condition>
  void drop(Condition condition) {
    std::deque<CollectedFrame>& frames = collected_.frames;
    frames.erase(std::remove_if(frames.begin(), frames.end(), condition), frames.end());
  }

  const ImageOptions image_options_;
  const double rate_;
  const ImageProfile expected_;
  const Model* model_;
  const ImageChange change_;
  const std::size_t most_;
  RepeatedImages repeated_;
  Continuity continuity_;              // of the frames that are not repeated
  std::vector<CameraStream> streams_;  // of the recording, by its number of the camera
  FrameCollection collected_;
  ExtractionPool pool_;  // the last member, so that its threads end first
};

}  // namespace

FrameCollection collectFrames(const std::vector<RecordingOpener>& recordings,
                              const TrainingOptions& options, const ImageProfile& profile,
                              const Model* model, const ImageChange& change, std::size_t most,
                              unsigned threads, const Progress& progress) {
  Collector collector(options, profile, model, change, most, threads);
  for (const RecordingOpener& open : recordings) collector.read(*open(), progress);
  return collector.finish();
}

}  // namespace place_recognition
