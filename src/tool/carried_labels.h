#pragma once

#include <string>
#include <vector>

#include "ros/bags/bag_recording.h"

namespace place_recognition::tool {

/// For each of `recordings` (at least one) the label that holds at its start because it goes on
/// where another of them ends, as the parts of a split recording do: a label is recorded when it is
/// said, in the part of that time. Empty: none. Says on stderr what is carried, and which part
/// lacks a label at its start.
std::vector<std::string> carriedLabels(const std::vector<std::string>& recordings,
                                       const BagRecordingOptions& options);

}  // namespace place_recognition::tool
