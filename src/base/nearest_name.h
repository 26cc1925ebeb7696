#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// The name in `known` of which `name` may be a misspelling: the one with the least edit distance
/// (letters inserted, omitted or replaced, or two neighbours exchanged; case is ignored), if that
/// is at most a third of the name's length, or 2 for a short name. Empty if none is that close.
std::string nearestName(const std::string& name, const std::vector<std::string>& known);

/// " (did you mean X?)" for the nearestName() X; empty if there is none.
std::string suggestion(const std::string& name, const std::vector<std::string>& known);

}  // namespace place_recognition
