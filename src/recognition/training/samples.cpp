#include "recognition/training/samples.h"

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "base/place_name.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "recognition/frames/extraction_pool.h"
#include "recognition/frames/image_guard.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/left_out_frames.h"
#include "recognition/frames/light.h"
#include "recognition/training/halving_sample.h"
#include "recognition/training/labelled_light.h"
#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

/// A labelled frame whose features are being extracted.
struct Record {
  std::string place;
  int recording = 0;
  double stamp = 0;
  int camera = 0;  // index into Samples::cameras
  std::string name;
  int level = 0;  // see HalvingSample
  ExtractedFeatures extracted;
  ExtractedFeatures changed;  // if that is asked for

  bool hasFeature() const { return extracted.problem.empty(); }
  bool hasChangedFeature() const { return !changed.features.empty() && changed.problem.empty(); }
};

/// What the label of a frame says, used or not.
struct Seen {
  double stamp = 0;
  std::string place;  // empty: unlabelled
};

/// One camera during a run.
struct CameraStream {
  int number;  // index into Samples::cameras
  ImageGuard guard;
  FrameRate rate;
  LabelledLight light;
};

/// Other light, if that is to be learned.
ImageChange changeOfLight(const TrainingOptions& options) {
  if (!options.augmentation.other_light) return {};
  const auto draw = std::make_shared<LightDraw>(options.seed);
  return [draw](const cv::Mat& image, const std::string& place) {
    return ChangedImage{inLight(image, draw->next(place)), {}};
  };
}

/// Reads runs and remembers what came of each frame.
class Collector {
 public:
  Collector(const TrainingOptions& options, const ImageProfile& profile, const Model* model,
            ImageChange change, unsigned threads)
      : image_options_(options.image),
        expected_(profile),
        profile_(profile),
        model_(model),
        sampling_(options.sampling),
        change_(std::move(change)),
        most_(static_cast<std::size_t>(options.sampling.most) / (change_ ? 2 : 1)),
        seed_(options.seed),
        fraction_(options.seed),
        cues_(options.cues.size()),
        pool_(options, profile, threads) {}

  Samples readAll(const std::vector<RecordingOpener>& recordings, const Progress& progress,
                  std::size_t least_places) {
    for (const RecordingOpener& open : recordings) read(*open(), progress);
    return finish(least_places);
  }

 private:
  void read(Recording& recording, const Progress& progress) {
    inputs_.push_back(recording.name());
    left_out_.emplace_back();
    seen_.emplace_back();
    recording.setDepthExtent(expected_.depth);
    std::vector<CameraStream> streams = streamsOf(recording);
    const std::string stage = "Reading " + recording.name();
    report(progress, stage, 0);
    for (Frame frame; recording.next(frame);) {
      CameraStream& stream = streams[static_cast<std::size_t>(frame.camera)];
      add(std::move(frame), stream);
      report(progress, stage, recording.fraction());
    }
    warnings_.insert(warnings_.end(), recording.warnings().begin(), recording.warnings().end());
  }

  std::vector<CameraStream> streamsOf(const Recording& recording) {
    std::vector<CameraStream> streams;
    for (const std::string& camera : recording.cameras()) {
      if (!isUtf8(camera))
        throw Error("A topic of images in " + recording.name() + " is not UTF-8 text.");
      const auto known = std::find(cameras_.begin(), cameras_.end(), camera);
      streams.push_back({static_cast<int>(known - cameras_.begin()),
                         ImageGuard(expected_, image_options_), FrameRate(sampling_.rate),
                         LabelledLight(model_)});
      if (known == cameras_.end()) cameras_.push_back(camera);
    }
    return streams;
  }

  Samples finish(std::size_t least_places) {
    pool_.finish();
    Samples samples;
    samples.inputs = inputs_;
    samples.cameras = cameras_;
    samples.image_profile = profile_;
    dropFeatureless();
    requirePlaces(least_places);
    samples.places.assign(places_.begin(), places_.end());
    thinOut(samples);
    fill(samples);
    learnRooms(samples);
    samples.warnings.insert(samples.warnings.end(), warnings_.begin(), warnings_.end());
    for (std::size_t r = 0; r < inputs_.size(); ++r) {
      samples.skipped += left_out_[r].count();
      for (const std::string& sentence : left_out_[r].sentences(inputs_[r])) {
        samples.warnings.push_back(sentence);
      }
    }
    warnOfPlaces(samples);
    return samples;
  }

  void add(Frame frame, CameraStream& camera) {
    ++frames_;
    seen_.back().push_back({frame.stamp, frame.place});
    requirePlaceName(frame);
    if (left_out_.back().takes(frame)) return;
    if (!camera.rate.admits(frame.stamp)) {
      ++passed_over_;
      return;
    }
    const std::optional<int> level = fraction_.next(frame.place);
    if (!level) return;
    for (const std::string& warning : camera.guard.judge(frame.image, frame.stamp)) {
      warnings_.push_back(inputs_.back() + ": " + warning);
    }
    include(statisticsOf(frame.image), profile_);
    const int recording = static_cast<int>(inputs_.size()) - 1;
    records_.push_back(
        {frame.place, recording, frame.stamp, camera.number, frame.name, *level, {}, {}});
    const Light light = camera.light.next(frame);
    pool_.submit(frame.image, records_.back().extracted, light);
    if (change_) {
      const ChangedImage changed = change_(frame.image, frame.place);
      pool_.submit(changed.image, records_.back().changed, light * changed.correction);
    }
    if (records_.size() > 2 * most_) dropHalf();
  }

  /// So that memory stays bounded.
  void dropHalf() {
    pool_.finish();
    dropFeatureless();
    fraction_.halve();
    dropRecords(
        [this](const Record& record) { return !fraction_.keeps(record.place, record.level); });
  }

  template <typename Condition>
  void dropRecords(Condition condition) {
    records_.erase(std::remove_if(records_.begin(), records_.end(), condition), records_.end());
  }

  static void requirePlaceName(const Frame& frame) {
    const std::string why_not = frame.place.empty() ? "" : whyNoPlaceName(frame.place);
    if (!why_not.empty()) {
      throw Error("The label '" + frame.place + "' of " + frame.name + " " + why_not);
    }
  }

  void dropFeatureless() {
    const auto featureless = [this](const Record& record) {
      if (record.hasFeature()) return false;
      left_out_[record.recording].add(record.place, record.name, record.extracted.problem);
      return true;
    };
    dropRecords(featureless);
  }

  void requirePlaces(std::size_t least_places) {
    for (const Record& record : records_) places_.insert(record.place);
    if (places_.size() < least_places) throw Error(whyTooFewPlaces());
    if (places_.size() > kMaxPlaces) {
      throw Error("The runs show " + std::to_string(places_.size()) + " places, more than " +
                  std::to_string(kMaxPlaces) + "; train a model for each part of the building.");
    }
  }

  /// Names the places that were labelled but have no image that can be used.
  void warnOfPlaces(Samples& samples) const {
    std::map<std::string, std::uint64_t> labelled;
    for (const std::vector<Seen>& recording : seen_) {
      for (const Seen& seen : recording) ++labelled[seen.place];
    }
    labelled.erase("");
    for (const auto& [place, count] : labelled) {
      if (places_.count(place) > 0) continue;
      const std::string problem = firstProblemOf(place);
      samples.warnings.push_back("'" + place + "' is not learned: its " + counted(count, "image") +
                                 " cannot be used" + (problem.empty() ? "" : " (" + problem + ")") +
                                 ".");
    }
  }

  std::string firstProblemOf(const std::string& place) const {
    for (const LeftOutFrames& recording : left_out_) {
      const auto problem = recording.firstProblems().find(place);
      if (problem != recording.firstProblems().end()) return problem->second;
    }
    return "";
  }

  std::string whyTooFewPlaces() const {
    std::string recordings;
    for (const std::string& input : inputs_) recordings += (recordings.empty() ? "" : ", ") + input;
    if (frames_ == 0) return "There are no images in " + recordings + "; give a run that has some.";
    if (places_.size() == 1) {
      return "All images in " + recordings + " show one place, '" + *places_.begin() +
             "'; a model needs two places or more to tell apart.";
    }
    for (const LeftOutFrames& recording : left_out_) {
      if (recording.firstProblem().empty()) continue;
      return "None of the images in " + recordings + " can be used (" + recording.firstProblem() +
             "); give a run that has some.";
    }
    return "None of the " + std::to_string(frames_) + " images in " + recordings +
           " has a label; say which place each of them shows.";
  }

  static int placeOf(const Record& record, const std::vector<std::string>& places) {
    return static_cast<int>(std::lower_bound(places.begin(), places.end(), record.place) -
                            places.begin());
  }

  /// Leaves no more records than may be learned.
  void thinOut(Samples& samples) {
    const std::vector<bool> kept = choose(samples.places);
    std::size_t next = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (!kept[i]) continue;
      if (next != i) records_[next] = std::move(records_[i]);
      ++next;
    }
    std::size_t left_out = records_.size() - next;
    records_.resize(next);
    for (const std::string& place : samples.places) left_out += fraction_.leftOut(place);
    samples.passed_over = passed_over_ + left_out;
    if (left_out == 0) return;
    samples.warnings.push_back(
        "Of " + std::to_string(left_out + next) + " images " + std::to_string(next) +
        " are learned, the same fraction of each room (sampling.most); of a fast "
        "camera sampling.rate=5 passes over more as it is read.");
  }

  /// Which records are learned: of each place the same fraction of all its frames.
  std::vector<bool> choose(const std::vector<std::string>& places) const {
    std::vector<std::size_t> frames;
    for (const std::string& place : places) frames.push_back(fraction_.leftOut(place));
    std::vector<int> rooms;
    for (const Record& record : records_) {
      rooms.push_back(placeOf(record, places));
      ++frames[static_cast<std::size_t>(rooms.back())];
    }
    return stratifiedSample(rooms, equalShares(frames, most_), seed_);
  }

  void fill(Samples& samples) {
    samples.images.assign(samples.places.size(), 0);
    samples.colours.assign(samples.places.size(), {});
    samples.features.resize(cues_);
    for (Record& record : records_) {
      const SampleOrigin origin{placeOf(record, samples.places), record.recording, record.stamp,
                                record.camera};
      ++samples.images[static_cast<std::size_t>(origin.place)];
      samples.colours[static_cast<std::size_t>(origin.place)].add(record.extracted.colour);
      append(origin, static_cast<int>(samples.origins.size()), record.extracted, samples);
    }
    samples.recorded = samples.origins.size();
    for (std::size_t i = 0; i < samples.recorded; ++i) {
      if (!records_[i].hasChangedFeature()) continue;
      append(samples.origins[i], static_cast<int>(i), records_[i].changed, samples);
    }
  }

  static void append(SampleOrigin origin, int source, ExtractedFeatures& extracted,
                     Samples& samples) {
    samples.origins.push_back(origin);
    samples.source.push_back(source);
    for (std::size_t c = 0; c < samples.features.size(); ++c) {
      samples.features[c].push_back(std::move(extracted.features[c]));
    }
  }

  void learnRooms(Samples& samples) const {
    samples.adjacency = Adjacency(samples.places.size());
    for (const std::vector<Seen>& recording : seen_) {
      std::vector<PlaceAt> places;
      for (const Seen& seen : recording) {
        const auto place =
            std::lower_bound(samples.places.begin(), samples.places.end(), seen.place);
        const bool known = place != samples.places.end() && *place == seen.place;
        places.push_back(
            {seen.stamp, known ? static_cast<int>(place - samples.places.begin()) : -1});
      }
      learnAdjacency(places, samples.adjacency);
    }
  }

  std::vector<std::string> inputs_;
  std::vector<std::string> cameras_;     // of all recordings
  std::vector<std::vector<Seen>> seen_;  // one per recording
  std::vector<LeftOutFrames> left_out_;  // one per recording
  std::vector<std::string> warnings_;    // of the recordings
  std::deque<Record> records_;           // stay where they are while threads fill them
  std::set<std::string> places_;
  std::uint64_t frames_ = 0;
  const ImageOptions image_options_;
  const ImageProfile expected_;  // to which images are brought, and are held against
  ImageProfile profile_;         // with those that came
  const Model* model_;           // null: none
  SamplingOptions sampling_;
  std::uint64_t passed_over_ = 0;  // by sampling.rate
  ImageChange change_;
  std::size_t most_;  // records that may be learned
  std::uint64_t seed_;
  HalvingSample fraction_;
  std::size_t cues_;
  ExtractionPool pool_;  // the last member: its threads end first
};

}  // namespace

Samples collectSamples(const std::vector<RecordingOpener>& recordings,
                       const TrainingOptions& options, unsigned threads, const Progress& progress,
                       std::size_t least_places, const std::optional<ImageProfile>& profile,
                       const ImageChange& change) {
  Collector collector(options, profile ? *profile : commonSize(recordings, progress), nullptr,
                      change ? change : changeOfLight(options), threads);
  return collector.readAll(recordings, progress, least_places);
}

Samples collectSamplesFor(const Model& model, const std::vector<RecordingOpener>& recordings,
                          const TrainingOptions& options, unsigned threads,
                          const Progress& progress, std::size_t least_places) {
  Collector collector(options, model.images, &model, changeOfLight(options), threads);
  return collector.readAll(recordings, progress, least_places);
}

}  // namespace place_recognition
