#include "tuning/search.h"

#include <algorithm>

namespace place_recognition {
namespace {

const Score& leastOf(const std::vector<Score>& scores) {
  return *std::min_element(scores.begin(), scores.end(),
                           [](const Score& a, const Score& b) { return a.log_loss < b.log_loss; });
}

}  // namespace

const TuningTrial& Search::note(const std::vector<CueOptions>& cues, double c,
                                const TuningSamples& samples, const Score& score) {
  trials.push_back(
      {stage, cues, c, samples.recorded, score.log_loss, score.rate, score.other_light_rate});
  return trials.back();
}

TrainingOptions Search::withCues(const std::vector<CueOptions>& cues) const {
  TrainingOptions options = base;
  options.cues = cues;
  options.augmentation.other_light = space.other_light;
  return options;
}

std::size_t firstAsGood(const std::vector<Score>& scores, const TuningSamples& samples) {
  const Score& least = leastOf(scores);
  std::size_t i = 0;
  while (scores[i].log_loss - least.log_loss > differenceError(scores[i], least, samples)) ++i;
  return i;
}

std::size_t firstNearlyAsGood(const std::vector<Score>& scores) {
  const Score& least = leastOf(scores);
  std::size_t i = 0;
  while (scores[i].log_loss - least.log_loss > least.standard_error) ++i;
  return i;
}

}  // namespace place_recognition
