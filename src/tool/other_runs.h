#pragma once

#include <string>
#include <vector>

namespace place_recognition::tool {

/// Throws UsageError if one of the runs to validate on is among the `learned` ones, in one of them,
/// or contains one.
void requireOtherRuns(const std::vector<std::string>& validate,
                      const std::vector<std::string>& learned);

}  // namespace place_recognition::tool
