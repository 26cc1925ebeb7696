#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// The name in `known` that `name` may be a misspelling of: the one at the least edit distance
/// (letters inserted, left out, replaced, or two neighbours exchanged; case does not count), if
/// that is at most a third of the name's length, or 2 for a short one. Empty: none is that near.
std::string nearestName(const std::string& name, const std::vector<std::string>& known);

}  // namespace place_recognition
