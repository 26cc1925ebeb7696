#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "place_recognition/recording.h"
#include "place_recognition/training.h"
#include "ros/bags/bag_recording.h"
#include "tool/verb.h"

namespace place_recognition::tool {

/// Help text that explains what an INPUT can be.
extern const char* const kInputHelp;

/// Options for reading and labelling the bags among a verb's inputs.
struct InputOptions {
  BagRecordingOptions bag;

  void addTo(Verb& verb);
  void addImageTopicTo(Verb& verb);

  /// The options for other runs than those to which --label and --labels apply.
  InputOptions withoutLabels() const;

  /// One opener per run of `inputs`, see partsInOrder(). `are_all`: the options apply to no other
  /// inputs. Throws Error for an input that is not a run, and if one labels file is given for
  /// several runs; UsageError like requireBag().
  std::vector<RecordingOpener> openers(const std::vector<std::string>& inputs,
                                       bool are_all = true) const;

  std::unique_ptr<Recording> open(const std::string& recording) const;

  /// Throws UsageError if one of these options is given but there is no bag among `paths`.
  void requireBag(const std::vector<std::string>& paths) const;
};

/// The option --threads of a verb.
void addThreads(Verb& verb, unsigned& threads);

/// The runs that `inputs` refer to, in the given order: a bag, a folder of `room/image`, or a
/// folder of such bags or folders, in natural order of their names; entries that yield nothing are
/// reported on stderr. Throws Error for anything else.
std::vector<std::string> findRecordings(const std::vector<std::string>& inputs);

/// An image as a frame without a label; `levels`: see Recording::setLevelRange(). The frame has no
/// image if the file is damaged. Throws Error if there is no image at `path`.
Frame imageFrame(const std::string& path, const LevelRange& levels);

/// An image, CV_8UC3 BGR or CV_8UC1. Throws Error if there is none at `path`, or if it is damaged.
cv::Mat readImage(const std::string& path);

}  // namespace place_recognition::tool
