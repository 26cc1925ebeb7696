#include <algorithm>
#include <string>

#include "place_recognition/error.h"
#include "place_recognition/tuning.h"

namespace place_recognition {
namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& what) {
  throw Error("Option '" + key + "' of the search space " + what + ".");
}

template <typename T>
void requireSome(const std::string& key, const std::vector<T>& values) {
  if (values.empty()) refuse(key, "is empty; name at least one value to try");
}

void requirePositive(const std::string& key, const std::vector<double>& values) {
  requireSome(key, values);
  if (!std::all_of(values.begin(), values.end(), [](double v) { return v > 0 && v < 1e12; })) {
    refuse(key, "holds a number that is not above 0; give positive ones");
  }
}

}  // namespace

void SearchSpace::check() const {
  requireSome("scales", scales);
  for (const std::vector<double>& set : scales) requirePositive("scales", set);
  requireSome("bins", bins);
  requirePositive("c", c);
  if (!cues.empty()) {
    TrainingOptions options;
    options.cues = cues;
    options.check();
  }
  if (max_dimensions < 1) refuse("max_dimensions", "is below 1; give 1 or more");
  if (max_cues < 1 || max_cues > 8) refuse("max_cues", "is not 1 to 8");
  if (first_pictures < 10) refuse("first_pictures", "is below 10; give more");
  if (max_pictures < first_pictures) {
    refuse("max_pictures", "is below 'first_pictures'; later rounds look at more images");
  }
}

}  // namespace place_recognition
