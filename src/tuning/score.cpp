#include "tuning/score.h"

#include <cmath>

#include "place_recognition/calibration.h"
#include "recognition/scores.h"

namespace place_recognition {
namespace {

/// Probabilities do not fall below this, so that no single picture decides.
constexpr double kSmallestProbability = 1e-3;

std::vector<int> testedSamples(const LitSamples& samples) {
  std::vector<int> tested;
  for (const Fold& fold : samples.folds) {
    tested.insert(tested.end(), fold.test.begin(), fold.test.end());
  }
  return tested;
}

Calibration calibrationOf(const HeldOut& held_out, const LitSamples& samples) {
  std::vector<int> labels;
  Eigen::MatrixXd margins(held_out.margins.rows(), held_out.margins.cols());
  for (std::size_t i = 0; i < held_out.valid.size(); ++i) {
    if (!held_out.valid[i]) continue;
    margins.row(static_cast<Eigen::Index>(labels.size())) =
        held_out.margins.row(static_cast<Eigen::Index>(i));
    labels.push_back(samples.origins[i].place);
  }
  return fitCalibration(margins.topRows(static_cast<Eigen::Index>(labels.size())), labels);
}

/// Mean, and variance of the mean, of one room's values.
struct RoomMoments {
  double sum = 0;
  double squares = 0;
  double count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double varianceOfMean() const { return std::max(0.0, squares / count - mean() * mean()) / count; }
};

/// Of the recorded samples that were tested, by room.
template <typename Value>
std::vector<RoomMoments> byRoom(const LitSamples& samples, const Value& value) {
  std::vector<RoomMoments> rooms(samples.places.size());
  for (const int i : testedSamples(samples)) {
    if (samples.source[i] == i) rooms[samples.origins[i].place].add(value(i));
  }
  return rooms;
}

}  // namespace

Score score(const HeldOut& held_out, const LitSamples& samples) {
  const Calibration calibration = calibrationOf(held_out, samples);
  Score result;
  result.losses.assign(samples.recorded, 0);
  std::vector<int> lights(samples.recorded, 0);
  std::vector<int> truth, answers, changed_truth, changed_answers;
  for (const int i : testedSamples(samples)) {
    const int place = samples.origins[i].place;
    const Eigen::RowVectorXd margins = held_out.margins.row(i);
    const double probability = calibration.probabilities(margins)[place];
    result.losses[samples.source[i]] -= std::log(std::max(kSmallestProbability, probability));
    ++lights[samples.source[i]];
    const bool recorded = samples.source[i] == i;
    (recorded ? truth : changed_truth).push_back(place);
    (recorded ? answers : changed_answers).push_back(held_out.valid[i] ? largest(margins) : -1);
  }
  for (std::size_t i = 0; i < samples.recorded; ++i) {
    if (lights[i] > 0) result.losses[i] /= lights[i];
  }

  const std::vector<RoomMoments> rooms = byRoom(samples, [&](int i) { return result.losses[i]; });
  double tested_rooms = 0;
  for (const RoomMoments& room : rooms) {
    if (room.count == 0) continue;
    result.log_loss += room.mean();
    ++tested_rooms;
  }
  if (tested_rooms > 0) result.log_loss /= tested_rooms;
  result.rate = averageRate(truth, answers, samples.places.size());
  result.changed_light_rate = averageRate(changed_truth, changed_answers, samples.places.size());
  return result;
}

double differenceError(const Score& a, const Score& b, const LitSamples& samples) {
  const std::vector<RoomMoments> rooms =
      byRoom(samples, [&](int i) { return a.losses[i] - b.losses[i]; });
  double variance = 0;
  double tested_rooms = 0;
  for (const RoomMoments& room : rooms) {
    if (room.count == 0) continue;
    variance += room.varianceOfMean();
    ++tested_rooms;
  }
  return tested_rooms > 0 ? std::sqrt(variance) / tested_rooms : 0;
}

}  // namespace place_recognition
