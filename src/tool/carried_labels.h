#pragma once

#include <string>
#include <vector>

#include "ros/bags/bag_recording.h"

namespace place_recognition::tool {

/// For each of `recordings` (at least one), the label valid at its start because the recording
/// continues another of them, like the parts of a split recording: a label is recorded when it is
/// said, in the part of that time. Empty if there is none. Reports on stderr what is carried over,
/// and which part has no label at its start.
std::vector<std::string> carriedLabels(const std::vector<std::string>& recordings,
                                       const BagRecordingOptions& options);

}  // namespace place_recognition::tool
