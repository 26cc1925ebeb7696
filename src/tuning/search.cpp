#include "tuning/search.h"

#include <algorithm>

namespace place_recognition {
TuningSamples Search::collect(const std::vector<CueOptions>& cues, std::size_t step,
                              const Progress& collect_progress) const {
  return collectTuningSamples(recordings, withCues(base, cues), space.other_light, step, threads,
                              collect_progress);
}

TuningTrial trialOf(const std::string& stage, const std::vector<CueOptions>& cues, double c,
                    const TuningSamples& samples, const Score& score) {
  return {stage, cues, c, samples.recorded, score.log_loss, score.rate, score.changed_rate};
}

TrainingOptions withCues(TrainingOptions options, const std::vector<CueOptions>& cues) {
  options.cues = cues;
  return options;
}

std::size_t leastOf(const std::vector<Score>& scores) {
  return static_cast<std::size_t>(
      std::min_element(scores.begin(), scores.end(),
                       [](const Score& a, const Score& b) { return a.log_loss < b.log_loss; }) -
      scores.begin());
}

std::size_t firstAsGood(const std::vector<Score>& scores, const TuningSamples& samples) {
  const Score& least = scores[leastOf(scores)];
  std::size_t i = 0;
  while (scores[i].log_loss - least.log_loss > differenceError(scores[i], least, samples)) ++i;
  return i;
}

std::size_t firstNearlyAsGood(const std::vector<Score>& scores) {
  const Score& least = scores[leastOf(scores)];
  std::size_t i = 0;
  while (scores[i].log_loss - least.log_loss > least.standard_error) ++i;
  return i;
}

}  // namespace place_recognition
