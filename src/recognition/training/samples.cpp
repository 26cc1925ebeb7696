#include "recognition/training/samples.h"

#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "base/place_name.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "recognition/frames/image_profile.h"
#include "recognition/model/place_index.h"
#include "recognition/training/frame_collection.h"
#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

/// Other light, if it is to be learned.
ImageChange changeOfLight(const TrainingOptions& options) {
  if (!options.augmentation.other_light) return {};
  const auto draw = std::make_shared<LightDraw>(options.seed);
  return [draw](const cv::Mat& image, const std::string& place) {
    return ChangedImage{inLight(image, draw->next(place)), {}};
  };
}

std::set<std::string> labelledPlaces(const FrameCollection& collected) {
  std::set<std::string> places;
  for (const std::vector<SeenLabel>& recording : collected.seen) {
    for (const SeenLabel& label : recording) {
      if (!label.place.empty()) places.insert(label.place);
    }
  }
  return places;
}

/// Why a frame was left out, in brackets.
std::string whyNoOthers(const FrameCollection& collected) {
  for (const LeftOutFrames& recording : collected.left_out) {
    if (!recording.firstProblem().empty()) return " (" + recording.firstProblem() + ")";
  }
  if (collected.passed_over == 0) return "";
  return " (sampling.rate passes over " + counted(collected.passed_over, "image") + ")";
}

/// Why the usable frames show fewer places than needed.
std::string whyTooFewPlaces(const FrameCollection& collected) {
  const std::string recordings = listed(collected.inputs);
  if (collected.images == 0) {
    return "There are no images in " + recordings + "; give a run with images.";
  }
  if (!collected.frames.empty() && labelledPlaces(collected).size() > 1) {
    return "Only '" + collected.frames.front().place + "' of the " +
           std::to_string(labelledPlaces(collected).size()) + " places in " + recordings +
           " has usable images" + whyNoOthers(collected) + "; a model needs at least two places.";
  }
  if (!collected.frames.empty()) {
    return "All images in " + recordings + " show one place, '" + collected.frames.front().place +
           "'; a model needs at least two places.";
  }
  for (const LeftOutFrames& recording : collected.left_out) {
    if (recording.firstProblem().empty()) continue;
    return "None of the images in " + recordings + " can be used (" + recording.firstProblem() +
           "); give a run with usable ones.";
  }
  return "None of " + counted(collected.images, "image") + " in " + recordings + " has a label; " +
         collected.how_to_label + ".";
}

/// Places of the usable frames, in ascending order.
std::vector<std::string> placesOf(const FrameCollection& collected, std::size_t least_places) {
  std::set<std::string> places;
  for (const CollectedFrame& frame : collected.frames) places.insert(frame.place);
  if (places.size() < least_places) throw Error(whyTooFewPlaces(collected));
  if (places.size() > kMaxPlaces) {
    throw Error("The runs show " + std::to_string(places.size()) + " places, more than " +
                std::to_string(kMaxPlaces) + "; train a model for each part of the building.");
  }
  return {places.begin(), places.end()};
}

/// The frames to learn: the same fraction of each place's frames, including those dropped during
/// reading, and `most` in total.
std::vector<bool> choose(const FrameCollection& collected, const std::vector<std::string>& places,
                         std::size_t most, std::uint64_t seed) {
  std::vector<std::size_t> frames;
  for (const std::string& place : places) frames.push_back(collected.sample.leftOut(place));
  std::vector<int> rooms;
  for (const CollectedFrame& frame : collected.frames) {
    rooms.push_back(placeIndex(frame.place, places));
    ++frames[static_cast<std::size_t>(rooms.back())];
  }
  return stratifiedSample(rooms, equalShares(frames, most), seed);
}

/// Reduces the frames to the number that may be learned.
void thinOut(FrameCollection& collected, std::size_t most, std::uint64_t seed, Samples& samples) {
  const std::vector<bool> kept = choose(collected, samples.places, most, seed);
  std::size_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    if (next != i) collected.frames[next] = std::move(collected.frames[i]);
    ++next;
  }
  std::size_t left_out = collected.frames.size() - next;
  collected.frames.resize(next);
  for (const std::string& place : samples.places) left_out += collected.sample.leftOut(place);
  samples.passed_over = collected.passed_over + left_out;
  if (left_out == 0) return;
  samples.warnings.push_back(
      "Of " + std::to_string(left_out + next) + " images " + std::to_string(next) +
      " are learned, the same fraction of each room (sampling.most); for a fast "
      "camera, sampling.rate=5 skips more while reading.");
}

void append(SampleOrigin origin, int source, ExtractedFeatures& extracted, Samples& samples) {
  samples.origins.push_back(origin);
  samples.source.push_back(source);
  for (std::size_t c = 0; c < samples.features.size(); ++c) {
    samples.features[c].push_back(std::move(extracted.features[c]));
  }
}

/// Converts the frames to samples with `cues` features.
void fill(FrameCollection& collected, std::size_t cues, Samples& samples) {
  samples.images.assign(samples.places.size(), 0);
  samples.colours.assign(samples.places.size(), {});
  samples.features.resize(cues);
  std::map<std::tuple<int, int, int>, int> next;  // the number that follows the last sample's
  for (CollectedFrame& frame : collected.frames) {
    SampleOrigin origin{placeIndex(frame.place, samples.places), frame.recording, frame.stamp,
                        frame.camera};
    int& expected = next[{origin.recording, origin.place, origin.camera}];
    origin.skipped = frame.number - expected;
    origin.part = frame.part;
    expected = frame.number + 1;
    ++samples.images[static_cast<std::size_t>(origin.place)];
    samples.colours[static_cast<std::size_t>(origin.place)].add(frame.extracted.colour);
    append(origin, static_cast<int>(samples.origins.size()), frame.extracted, samples);
  }
  samples.recorded = samples.origins.size();
  for (std::size_t i = 0; i < samples.recorded; ++i) {
    if (!collected.frames[i].hasChangedFeature()) continue;
    append(samples.origins[i], static_cast<int>(i), collected.frames[i].changed, samples);
  }
}

Adjacency adjacencyOf(const FrameCollection& collected, const std::vector<std::string>& places) {
  Adjacency adjacency(places.size());
  for (const std::vector<SeenLabel>& recording : collected.seen) {
    std::vector<PlaceAt> way;
    for (const SeenLabel& seen : recording)
      way.push_back({seen.stamp, placeIndex(seen.place, places)});
    learnAdjacency(way, adjacency);
  }
  return adjacency;
}

std::string firstProblemOf(const std::string& place, const FrameCollection& collected) {
  for (const LeftOutFrames& recording : collected.left_out) {
    const auto problem = recording.firstProblems().find(place);
    if (problem != recording.firstProblems().end()) return problem->second;
  }
  return "";
}

/// Warns of places that were labelled but have no usable image.
void warnOfPlaces(const FrameCollection& collected, Samples& samples) {
  std::map<std::string, std::uint64_t> labelled;
  for (const std::vector<SeenLabel>& recording : collected.seen) {
    for (const SeenLabel& seen : recording) ++labelled[seen.place];
  }
  labelled.erase("");
  for (const auto& [place, count] : labelled) {
    if (placeIndex(place, samples.places) >= 0) continue;
    const std::string problem = firstProblemOf(place, collected);
    samples.warnings.push_back("'" + place + "' is not learned: its " + counted(count, "image") +
                               " cannot be used" + (problem.empty() ? "" : " (" + problem + ")") +
                               ".");
  }
}

/// Reports what was left out and why.
void warn(const FrameCollection& collected, Samples& samples) {
  samples.warnings.insert(samples.warnings.end(), collected.warnings.begin(),
                          collected.warnings.end());
  for (std::size_t r = 0; r < collected.inputs.size(); ++r) {
    samples.skipped += collected.left_out[r].count();
    for (const std::string& sentence : collected.left_out[r].sentences(collected.inputs[r])) {
      samples.warnings.push_back(sentence);
    }
  }
  warnOfPlaces(collected, samples);
}

Samples collect(const std::vector<RecordingOpener>& recordings, const TrainingOptions& options,
                const ImageProfile& profile, const Model* model, const ImageChange& change,
                unsigned threads, const Progress& progress, std::size_t least_places) {
  const std::size_t most = static_cast<std::size_t>(options.sampling.most) / (change ? 2 : 1);
  FrameCollection collected =
      collectFrames(recordings, options, profile, model, change, most, threads, progress);
  Samples samples;
  samples.inputs = collected.inputs;
  samples.sketches = collected.sketches;
  samples.cameras = collected.cameras;
  samples.image_profile = collected.profile;
  samples.places = placesOf(collected, least_places);
  thinOut(collected, most, options.seed, samples);
  fill(collected, options.cues.size(), samples);
  samples.adjacency = adjacencyOf(collected, samples.places);
  warn(collected, samples);
  return samples;
}

}  // namespace

Samples collectSamples(const std::vector<RecordingOpener>& recordings,
                       const TrainingOptions& options, unsigned threads, const Progress& progress,
                       std::size_t least_places, const std::optional<ImageProfile>& profile,
                       const ImageChange& change) {
  return collect(recordings, options, profile ? *profile : commonSize(recordings, progress),
                 nullptr, change ? change : changeOfLight(options), threads, progress,
                 least_places);
}

Samples collectSamplesFor(const Model& model, const std::vector<RecordingOpener>& recordings,
                          const TrainingOptions& options, unsigned threads,
                          const Progress& progress, std::size_t least_places) {
  return collect(recordings, options, model.images, &model, changeOfLight(options), threads,
                 progress, least_places);
}

}  // namespace place_recognition
