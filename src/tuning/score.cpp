#include "tuning/score.h"

#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

/// As recorded and changed.
std::vector<int> testedSamples(const TuningSamples& samples) {
  std::vector<int> tested;
  for (const Fold& fold : samples.folds) {
    tested.insert(tested.end(), fold.test.begin(), fold.test.end());
  }
  return tested;
}

/// The mean of `value` over the tested recorded samples.
template <typename Value>
RoomMean meanOfTested(const TuningSamples& samples, const Value& value) {
  std::vector<int> truth;
  std::vector<double> values;
  for (const int i : testedSamples(samples)) {
    if (samples.source[i] != i) continue;
    truth.push_back(samples.origins[i].place);
    values.push_back(value(i));
  }
  return roomMean(truth, values, samples.places.size());
}

}  // namespace

Score score(const HeldOutValues& held_out, const TuningSamples& samples) {
  const std::vector<int> tested = testedSamples(samples);
  const std::vector<double> losses = logLosses(held_out, samples.origins, tested);
  Score result;
  result.losses.assign(samples.recorded, 0);
  std::vector<int> images(samples.recorded, 0);
  std::vector<int> truth, answers, changed_truth, changed_answers;
  for (std::size_t k = 0; k < tested.size(); ++k) {
    const int i = tested[k];
    const int source = samples.source[i];
    result.losses[source] += losses[k];
    ++images[source];
    const int answer = held_out.valid[i] ? largest(held_out.decision_values.row(i)) : -1;
    (source == i ? truth : changed_truth).push_back(samples.origins[i].place);
    (source == i ? answers : changed_answers).push_back(answer);
  }
  for (std::size_t i = 0; i < samples.recorded; ++i) {
    if (images[i] > 0) result.losses[i] /= images[i];
  }
  const RoomMean mean = meanOfTested(samples, [&](int i) { return result.losses[i]; });
  result.log_loss = mean.mean;
  result.standard_error = mean.standard_error;
  result.rate = averageRate(truth, answers, samples.places.size());
  result.changed_rate = averageRate(changed_truth, changed_answers, samples.places.size());
  return result;
}

double differenceError(const Score& a, const Score& b, const TuningSamples& samples) {
  return meanOfTested(samples, [&](int i) { return a.losses[i] - b.losses[i]; }).standard_error;
}

}  // namespace place_recognition
