#pragma once

#include <ros/time.h>

#include <cstdint>
#include <ctime>
#include <map>
#include <memory>
#include <string>

#include "base/folder_lock.h"
#include "place_recognition/recognizer.h"
#include "ros/bags/staged_bag.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"

namespace place_recognition {

/// Which doubtful frames a recognizer keeps, and where.
struct KeepOptions {
  std::string folder;       ///< empty: nothing is kept
  int per_hour = 240;       ///< maximum number of frames, spread evenly over time
  int megabytes = 500;      ///< of all bags in the folder; the oldest are removed
  std::string label_topic;  ///< resolved
};

/// Reads the parameters `~keep_...`.
KeepOptions readKeepOptions(Parameters& parameters, const std::string& label_topic);

/// Keeps the frames that the model should learn next: those answered 'unknown', and those whose
/// answer differs from that of the previous frame. They are written to bags `doubtful_<UTC
/// time>.bag` with the place over time as their label, so that a person only needs to correct it. A
/// bag ends after an hour or an eighth of the megabytes. Bags with a person's labels beside them
/// (`doubtful_<UTC time>.labels.yaml`) are neither counted nor removed. If writing fails, keeping
/// ends with a message, but the node continues. Not thread-safe, except for isKeeping().
class DoubtfulFrames {
 public:
  /// Throws Error if the folder cannot be created or written to, or if another recognizer keeps its
  /// frames there.
  explicit DoubtfulFrames(KeepOptions options);

  /// Completes the bag.
  ~DoubtfulFrames();
  DoubtfulFrames(const DoubtfulFrames&) = delete;
  DoubtfulFrames& operator=(const DoubtfulFrames&) = delete;

  bool isKeeping() const { return !options_.folder.empty(); }

  /// Keeps the image on `topic` if its answer `recognition` is doubtful. `place`: the answer over
  /// time.
  void take(const std::string& topic, const ImageMessage& image, const Recognition& recognition,
            const std::string& place);

 private:
  static KeepOptions prepared(KeepOptions options);
  bool isDoubtful(const std::string& topic, const Recognition& recognition);
  void keep(const std::string& topic, const ImageMessage& image, const std::string& place);
  void begin(const ros::Time& time);
  void finishBag();
  /// Removes the oldest bags until the next one fits within the megabytes.
  void removeOldest() const;

  const KeepOptions options_;
  std::unique_ptr<FolderLock> lock_;
  bool failed_ = false;                     // writing has failed
  ros::Time due_;                           // time of the next frame to keep
  std::map<std::string, int> last_places_;  // the answer to the last frame of each topic
  std::unique_ptr<StagedBag> bag_;          // null: no frame since the last bag ended
  std::time_t named_ = 0;                   // the time in its name
  ros::Time begin_, last_;                  // of its frames
  std::uint64_t bytes_ = 0;                 // of the bag
  std::uint64_t images_ = 0;                // in the bag
  std::string label_;                       // the current label in the bag
};

}  // namespace place_recognition
