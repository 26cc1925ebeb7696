#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/level_range.h"

namespace place_recognition {

/// One image of a recording.
struct Frame {
  cv::Mat image;        ///< CV_8UC3 BGR or CV_8UC1; empty if it could not be decoded, see `problem`
  std::string place;    ///< label; empty: unlabelled
  double stamp = 0;     ///< s
  int camera = 0;       ///< index in Recording::cameras()
  std::string name;     ///< for messages: path of the image, or topic and number in a bag
  std::string problem;  ///< why there is no image, for a person
};

/// One recording, a bag or a folder, read sequentially one frame at a time, in memory that does not
/// grow with its length.
class Recording {
 public:
  virtual ~Recording() = default;

  /// Reads the next frame, in order of time; false at the end. Throws Error if the run is damaged.
  virtual bool next(Frame& frame) = 0;

  /// The cameras of the recording, by the topics of their images; at least one.
  virtual std::vector<std::string> cameras() const { return {""}; }

  /// The size of most images, as far as a few of them show it; 0 x 0 if no image can be decoded.
  /// May advance the recording.
  virtual cv::Size usualSize() {
    for (Frame frame; next(frame);) {
      if (!frame.image.empty()) return frame.image.size();
    }
    return {};
  }

  /// What a person can do if none of the images has a label; a phrase without a full stop.
  virtual std::string howToLabel() const { return "label them with their places"; }

  /// The part read so far, 0..1.
  virtual double fraction() const = 0;

  /// Sets how images of 16 bits per channel are converted to the 8 bits of a Frame: by `range` if
  /// it is known, else by the range of a few images from the whole recording. Call it before
  /// next().
  virtual void setLevelRange(const LevelRange& /*range*/) {}

  /// The range of a few images from the whole recording, once next() or usualSize() has been
  /// called; unknown if they do not have 16 bits per channel.
  virtual LevelRange levelRange() const { return {}; }

  /// The name that the user gave.
  const std::string& name() const { return name_; }

  /// What a person should know about the recording as a whole, one sentence each: folders without
  /// images, labels read in an unusual way.
  const std::vector<std::string>& warnings() const { return warnings_; }

 protected:
  explicit Recording(std::string name) : name_(std::move(name)) {}

  std::vector<std::string> warnings_;

 private:
  std::string name_;
};

/// Opens a folder of `room/image` files: the sub-folder is the place; images are in natural order
/// (9 before 10), one second apart. Images of a room may lie in folders below its own. Images
/// directly in `folder` are unlabelled. Throws Error if there is no image.
std::unique_ptr<Recording> openFolderRecording(const std::string& folder);

}  // namespace place_recognition
