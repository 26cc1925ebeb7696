#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// The index of `name` in `places`, which are in ascending order; -1 if it is not one of them.
int placeIndex(const std::string& name, const std::vector<std::string>& places);

}  // namespace place_recognition
