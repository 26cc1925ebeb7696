#pragma once

#include <iosfwd>
#include <string>

#include "ros/bags/bag_recording.h"
#include "tool/output.h"

namespace place_recognition::tool {

/// Describes the bag at `path` for a person.
void printBag(const BagInfo& bag, const std::string& path, std::ostream& out);

/// The same for a program.
Json bagFigures(const BagInfo& bag, const std::string& path);

}  // namespace place_recognition::tool
