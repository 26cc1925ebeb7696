#include "recognition/training/training_warnings.h"

#include <algorithm>

#include "base/text.h"

namespace place_recognition {

void warnOfFewImages(const Samples& samples, int folds, std::vector<std::string>& warnings) {
  constexpr int kEnoughFolds = 5;
  const auto enough = static_cast<std::uint64_t>(2 * std::min(folds, kEnoughFolds));
  for (std::size_t k = 0; k < samples.images.size(); ++k) {
    if (samples.images[k] >= enough) continue;
    warnings.push_back("The place '" + samples.places[k] + "' has only " +
                       counted(samples.images[k], "image") +
                       "; its answers and their confidence will be poor. Record more of it.");
  }
}

void warnOfConfusedPairs(const std::vector<ConfusedPair>& pairs,
                         const std::vector<std::string>& places,
                         std::vector<std::string>& warnings) {
  constexpr double kWorthAWord = 0.1;
  for (const ConfusedPair& pair : pairs) {
    if (pair.rate - pair.standard_error < kWorthAWord) continue;
    warnings.push_back("'" + places[static_cast<std::size_t>(pair.a)] + "' and '" +
                       places[static_cast<std::size_t>(pair.b)] +
                       "' look alike: " + percent(pair.rate, 0) +
                       " of their held-out images are mistaken for the other place.");
  }
}

void warnOfLearnedRuns(const Model& model, const Samples& samples,
                       std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < samples.inputs.size(); ++i) {
    if (!isLearned(samples.sketches[i], model.provenance.sketches)) continue;
    warnings.push_back("The model was already trained on " + samples.inputs[i] +
                       ", so the figures of held-out images are too good; give new runs.");
  }
}

void warnOfLearnedTest(const Model& model, const std::string& run, const RunSketch& sketch,
                       std::vector<std::string>& warnings) {
  if (!isLearned(sketch, model.provenance.sketches)) return;
  warnings.push_back("The model was trained on " + run +
                     ", so it seems to be right and sure more often than on other runs.");
}

void warnOfTightLimit(const Model& model, int vector_limit, std::vector<std::string>& warnings) {
  if (vector_limit == 0) return;
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    const std::size_t before = model.classifiers[c].supportVectorCount();
    if (2 * static_cast<std::size_t>(vector_limit) >= before) continue;
    warnings.push_back("The limit keeps " + counted(vector_limit, "support vector") + " of " +
                       std::to_string(before) +
                       " that the model had, so its confidence and the figures of held-out images "
                       "are too good; calibrate the model on another run.");
    return;
  }
}

}  // namespace place_recognition
