#include "recognition/model/place_index.h"

#include <algorithm>

namespace place_recognition {

int placeIndex(const std::string& name, const std::vector<std::string>& places) {
  const auto found = std::lower_bound(places.begin(), places.end(), name);
  return found != places.end() && *found == name ? static_cast<int>(found - places.begin()) : -1;
}

}  // namespace place_recognition
