#include "tuning/recorded_images.h"

#include <set>
#include <string_view>

#include "base/sha256.h"
#include "place_recognition/error.h"
#include "recognition/frames/image_hash.h"

namespace place_recognition {
namespace {

std::string digestOf(const cv::Mat& image) {
  const cv::Mat whole = image.isContinuous() ? image : image.clone();
  return sha256({reinterpret_cast<const char*>(whole.data), whole.total() * whole.elemSize()});
}

/// The properties of a frame on which a search depends.
std::string describe(const Frame& frame) {
  std::string text = frame.place;
  for (const int number : {frame.camera, frame.image.rows, frame.image.cols, frame.image.type()}) {
    text += "\n" + std::to_string(number);
  }
  const double stamp = frame.stamp;
  text.append("\n").append(reinterpret_cast<const char*>(&stamp), sizeof(stamp));
  return text + "\n" + digestOf(frame.image);
}

/// What is known of several recordings.
struct Seen {
  std::set<std::string> places;
  std::vector<std::string> names;
  std::vector<RunSketch> sketches;  // of each
};

Seen lookThrough(const std::vector<RecordingOpener>& recordings, RecordedImages& found,
                 const Progress& progress) {
  Seen seen;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const std::unique_ptr<Recording> recording = recordings[r]();
    seen.names.push_back(recording->name());
    seen.sketches.emplace_back();
    for (Frame frame; recording->next(frame);) {
      found.labelled += frame.place.empty() ? 0 : 1;
      if (!frame.place.empty()) seen.places.insert(frame.place);
      addLabelled(frame, seen.sketches.back());
      found.digest = sha256(found.digest + describe(frame));
      report(progress, "Counting images",
             (static_cast<double>(r) + recording->fraction()) /
                 static_cast<double>(recordings.size()));
    }
    const LevelRange levels = recording->levelRange();
    found.digest = sha256(found.digest + " end " + std::to_string(levels.low) + " " +
                          std::to_string(levels.high));
  }
  return seen;
}

}  // namespace

RecordedImages lookThrough(const TuningRecordings& recordings, const Progress& progress) {
  RecordedImages found;
  const Seen learned = lookThrough(recordings.recordings, found, progress);
  found.digest += " held out ";
  const Seen held_out = lookThrough(recordings.hold_out, found, progress);
  for (const std::string& place : held_out.places) {
    if (learned.places.count(place) > 0) continue;
    throw Error("The runs to validate on show '" + place +
                "', which no other run shows; leave it out of them, or learn it.");
  }
  for (std::size_t i = 0; i < held_out.names.size(); ++i) {
    if (!isLearned(held_out.sketches[i], learned.sketches)) continue;
    throw Error("The runs to validate on: most images of " + held_out.names[i] +
                " are also learned; give another run.");
  }
  return found;
}

}  // namespace place_recognition
