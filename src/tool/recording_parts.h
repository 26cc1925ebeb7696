#pragma once

#include <string>
#include <vector>

#include "ros/bags/bag_recording.h"

namespace place_recognition::tool {

/// A recording to read, which may be a part of a split one.
struct RecordingPart {
  std::string path;
  std::string initial_label;  ///< valid at its start, as said in the part before; empty: none
};

/// `recordings` in the given order, except that a bag that starts where another one of the same
/// camera ends, like the next part of a split recording, directly follows that one. A label is
/// recorded when it is said, in the part of that time; unless `options` name the labels, it is
/// carried into the parts that follow. Reports on stderr what is carried over, and which part has
/// no label at its start.
std::vector<RecordingPart> partsInOrder(const std::vector<std::string>& recordings,
                                        const BagRecordingOptions& options);

}  // namespace place_recognition::tool
