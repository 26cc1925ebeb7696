#include "tuning/recorded_images.h"

#include <set>
#include <string_view>

#include "base/sha256.h"
#include "place_recognition/error.h"

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

/// Returns the places of the recordings.
std::set<std::string> lookThrough(const std::vector<RecordingOpener>& recordings,
                                  RecordedImages& found, const Progress& progress) {
  std::set<std::string> places;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const std::unique_ptr<Recording> recording = recordings[r]();
    for (Frame frame; recording->next(frame);) {
      found.labelled += frame.place.empty() ? 0 : 1;
      if (!frame.place.empty()) places.insert(frame.place);
      found.digest = sha256(found.digest + describe(frame));
      report(progress, "Counting images",
             (static_cast<double>(r) + recording->fraction()) /
                 static_cast<double>(recordings.size()));
    }
    const LevelRange levels = recording->levelRange();
    found.digest = sha256(found.digest + " end " + std::to_string(levels.low) + " " +
                          std::to_string(levels.high));
  }
  return places;
}

}  // namespace

RecordedImages lookThrough(const TuningRecordings& recordings, const Progress& progress) {
  RecordedImages found;
  const std::set<std::string> learned = lookThrough(recordings.recordings, found, progress);
  found.digest += " held out ";
  for (const std::string& place : lookThrough(recordings.hold_out, found, progress)) {
    if (learned.count(place) > 0) continue;
    throw Error("The runs to validate on show '" + place +
                "', which no other run shows; leave it out of them, or learn it.");
  }
  return found;
}

}  // namespace place_recognition
