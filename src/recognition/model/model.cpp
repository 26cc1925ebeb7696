#include "place_recognition/model.h"

#include <algorithm>

namespace place_recognition {

std::size_t Model::supportVectorCount() const {
  std::size_t count = 0;
  for (const Classifier& classifier : classifiers) count += classifier.supportVectorCount();
  return count;
}

std::vector<std::string> Model::validatedPlaces() const {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool judged =
        std::count(held_out.places.begin(), held_out.places.end(), static_cast<int>(k)) > 0;
    if (judged) names.push_back(places[k]);
  }
  return names;
}

}  // namespace place_recognition
