#include "tuning/search.h"

#include <algorithm>

namespace place_recognition {

const TuningTrial& Search::note(const std::vector<CueOptions>& cues, double c,
                                const LitSamples& samples, const Score& score) {
  trials.push_back(
      {stage, cues, c, samples.recorded, score.log_loss, score.rate, score.changed_light_rate});
  return trials.back();
}

TrainingOptions Search::withCues(const std::vector<CueOptions>& cues) const {
  TrainingOptions options = base;
  options.cues = cues;
  return options;
}

std::size_t preferred(const std::vector<Score>& scores, const LitSamples& samples) {
  const auto least =
      std::min_element(scores.begin(), scores.end(),
                       [](const Score& a, const Score& b) { return a.log_loss < b.log_loss; });
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double surplus = scores[i].log_loss - least->log_loss;
    if (surplus <= differenceError(scores[i], *least, samples)) return i;
  }
  return static_cast<std::size_t>(least - scores.begin());
}

}  // namespace place_recognition
