#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/recording.h"
#include "place_recognition/training.h"
#include "ros/bags/bag_recording.h"
#include "tool/command_line.h"

namespace place_recognition::tool {

/// The help text on what an INPUT may be.
extern const char* const kInputHelp;

/// How the bags among a verb's inputs are read and labelled.
struct InputOptions {
  BagRecordingOptions bag;

  void addTo(Verb& verb);

  /// One opener a run of `inputs`. Throws Error for an input that is no run, and where one file of
  /// labels is given for several.
  std::vector<RecordingOpener> openers(const std::vector<std::string>& inputs) const;

  std::unique_ptr<Recording> open(const std::string& recording) const;
};

/// The runs that `inputs` stand for, in the order given: a bag; a folder of `room/image`; a
/// folder of such bags or folders, in natural order of their names, of which those that give
/// nothing are named on stderr. Throws Error for anything else.
std::vector<std::string> findRecordings(const std::vector<std::string>& inputs);

/// An image as a frame without a label, `depth` as of Recording::setDepthExtent(); it has no image
/// if it is damaged. Throws Error if there is none at `path`.
Frame imageFrame(const std::string& path, const DepthExtent& depth);

/// An image, CV_8UC3 BGR or CV_8UC1. Throws Error if there is none at `path`, or it is damaged.
cv::Mat readImage(const std::string& path);

}  // namespace place_recognition::tool
