#include <string>

#include "base/require.h"
#include "place_recognition/tuning.h"

namespace place_recognition {
namespace {

void requirePositive(const std::string& key, const std::vector<double>& values) {
  requireSome(values, key, "at least one value to try");
  for (const double value : values) {
    requireOption(value > 0 && value < 1e12, key, value, "numbers above 0, below 1e12");
  }
}

}  // namespace

void SearchSpace::check() const {
  requireSome(scales, "scales", "at least one set of scales to try");
  for (const std::vector<double>& set : scales) requirePositive("scales", set);
  requireSome(bins, "bins", "at least one number to try");
  requirePositive("c", c);
  if (!cues.empty()) {
    TrainingOptions options;
    options.cues = cues;
    options.check();
  }
  requireOption(max_dimensions >= 1, "max_dimensions", max_dimensions, "1 or more");
  requireOption(max_cues >= 1 && max_cues <= 8, "max_cues", max_cues, "1 to 8");
  requireOption(first_pictures >= 10, "first_pictures", first_pictures, "10 or more");
  requireOption(max_pictures >= first_pictures, "max_pictures", max_pictures,
                "at least " + std::to_string(first_pictures) +
                    " (first_pictures), because later rounds look at more images");
}

}  // namespace place_recognition
