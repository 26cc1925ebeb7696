#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/depth_extent.h"

namespace place_recognition {

/// One image of a recording.
struct Frame {
  cv::Mat image;        ///< CV_8UC3 BGR or CV_8UC1; empty if it could not be decoded, see `problem`
  std::string place;    ///< label; empty: unlabelled
  double stamp = 0;     ///< s
  int camera = 0;       ///< index in Recording::cameras()
  std::string name;     ///< path of the image, or topic and number in a bag, for messages
  std::string problem;  ///< why there is no image, for a person
};

/// One recording, a bag or a folder, read from its start to its end, a frame at a time, in memory
/// that does not grow with its length.
class Recording {
 public:
  virtual ~Recording() = default;

  /// The next frame, in order of time; false at the end. Throws Error if the run is damaged.
  virtual bool next(Frame& frame) = 0;

  /// The cameras that its frames are of, by the topics of their images; at least one.
  virtual std::vector<std::string> cameras() const { return {""}; }

  /// How much has been read, 0..1.
  virtual double fraction() const = 0;

  /// How images of 16 bits are brought to the 8 of a Frame, to be called before next(): by `extent`
  /// if it is known, else by that of a few images from all of the recording.
  virtual void setDepthExtent(const DepthExtent& /*extent*/) {}

  /// The extent of a few images from all of the recording, once next() has been called; not known
  /// if they are not of 16 bits.
  virtual DepthExtent depthExtent() const { return {}; }

  /// As the user named it.
  const std::string& name() const { return name_; }

  /// What a person should know of the recording as a whole, a sentence each: folders that give no
  /// image, labels that were read in an unusual way.
  const std::vector<std::string>& warnings() const { return warnings_; }

 protected:
  explicit Recording(std::string name) : name_(std::move(name)) {}

  std::vector<std::string> warnings_;

 private:
  std::string name_;
};

/// A folder of `room/image` files: the sub-folder is the place, the order that of the names as
/// people number them (9 before 10), one second apart. The images of a room may lie in folders
/// below its own. Images directly in `folder` are unlabelled. Throws Error if there is no
/// image.
std::unique_ptr<Recording> openFolderRecording(const std::string& folder);

}  // namespace place_recognition
