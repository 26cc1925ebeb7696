#pragma once

#include <string>
#include <vector>

#include "ros/bag_run.h"

namespace place_recognition::tool {

/// For each of `runs` the label that holds at its start because it goes on where the bag before it
/// ends, as the parts of a split recording do: a label is recorded when it is said, in the part of
/// that time. Empty: none. Says on stderr what is carried, and which bag has no label at all.
std::vector<std::string> carriedLabels(const std::vector<std::string>& runs,
                                       const BagRunOptions& options);

}  // namespace place_recognition::tool
