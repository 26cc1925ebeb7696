#include "recognition/training/held_out_values.h"

#include <algorithm>
#include <cmath>

#include "learning/selection.h"
#include "place_recognition/calibration.h"

namespace place_recognition {
namespace {

/// True places of the valid samples, and the places with their largest decision values.
struct Answers {
  std::vector<int> truth, places;
};

Answers answersOf(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples) {
  Answers answers;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!held_out.valid[i]) continue;
    answers.truth.push_back(samples[i].place);
    answers.places.push_back(largest(held_out.decision_values.row(static_cast<Eigen::Index>(i))));
  }
  return answers;
}

constexpr double kSmallestProbability = 1e-3;

Calibration calibrationOf(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                          const std::vector<int>& chosen) {
  std::vector<int> valid, labels;
  for (const int i : chosen) {
    if (!held_out.valid[static_cast<std::size_t>(i)]) continue;
    valid.push_back(i);
    labels.push_back(samples[static_cast<std::size_t>(i)].place);
  }
  return fitCalibration(pickRows(held_out.decision_values, valid), labels);
}

}  // namespace

HeldOutValues HeldOutValues::none(std::size_t samples, std::size_t places) {
  const auto rows = static_cast<Eigen::Index>(samples);
  return {Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(places)),
          std::vector<bool>(samples, false), Eigen::VectorXd::Zero(rows)};
}

void HeldOutValues::set(int sample, const Eigen::RowVectorXd& values, double largest_kernel_value) {
  decision_values.row(sample) = values;
  familiarity[sample] = largest_kernel_value;
  valid[static_cast<std::size_t>(sample)] = true;
}

RoomMean roomRates(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places) {
  const Answers answers = answersOf(held_out, samples);
  return roomRates(answers.truth, answers.places, places);
}

double averageRate(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                   std::size_t places) {
  return roomRates(held_out, samples, places).mean;
}

std::vector<ConfusedPair> confusedPairs(const HeldOutValues& held_out,
                                        const std::vector<SampleOrigin>& samples,
                                        std::size_t places) {
  const Answers answers = answersOf(held_out, samples);
  return confusedPairs(answers.truth, answers.places, places);
}

std::vector<double> logLosses(const HeldOutValues& held_out,
                              const std::vector<SampleOrigin>& samples,
                              const std::vector<int>& chosen) {
  const Calibration calibration = calibrationOf(held_out, samples, chosen);
  std::vector<double> losses;
  for (const int i : chosen) {
    const double probability = calibration.probabilities(
        held_out.decision_values.row(i))[samples[static_cast<std::size_t>(i)].place];
    losses.push_back(-std::log(std::max(kSmallestProbability, probability)));
  }
  return losses;
}

}  // namespace place_recognition
