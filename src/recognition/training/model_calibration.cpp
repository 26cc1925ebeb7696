#include "recognition/training/model_calibration.h"

#include <algorithm>

#include "base/quantile.h"
#include "learning/selection.h"
#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

Calibration fit(const CombinedValues& held_out, const CalibrationSet& set,
                const std::vector<int>& chosen, double false_alarm_rate) {
  std::vector<int> labels;
  for (const int sample : chosen) labels.push_back(set.samples[sample].place);
  Calibration calibration = fitCalibration(pickRows(held_out.decision_values, chosen), labels);

  Eigen::VectorXd log_sums(chosen.size());
  Eigen::VectorXd familiarity(chosen.size());
  Eigen::Index judges = 0;
  for (const int sample : chosen) {
    if (!set.judges_unknown[sample]) continue;
    log_sums[judges] = calibration.logSum(held_out.unlimited.row(sample));
    familiarity[judges] = held_out.familiarity[sample];
    ++judges;
  }
  calibration.weights =
      fitEvidence(log_sums.head(judges), familiarity.head(judges), false_alarm_rate);
  return calibration;
}

/// Answers to held-out samples.
struct Answers {
  std::vector<int> truth, places;
  std::vector<double> confidences, evidence;
  std::vector<bool> correct;

  void add(const CombinedValues& held_out, int sample, int place, const Calibration& calibration,
           bool judges_unknown) {
    const Eigen::RowVectorXd probabilities =
        calibration.probabilities(held_out.decision_values.row(sample));
    truth.push_back(place);
    places.push_back(largest(probabilities));
    confidences.push_back(probabilities[places.back()]);
    if (judges_unknown) {
      evidence.push_back(
          calibration.evidence(held_out.unlimited.row(sample), held_out.familiarity[sample]));
    }
    correct.push_back(places.back() == place);
  }
};

/// The valid samples that are tested in `fold` (inside) or in another one; all if there are none.
std::vector<int> validSamples(const HeldOutValues& held_out, const std::vector<int>& fold_of,
                              int fold, bool inside) {
  std::vector<int> chosen;
  for (std::size_t i = 0; i < fold_of.size(); ++i) {
    if (held_out.valid[i] && (fold_of[i] == fold) == inside) chosen.push_back(static_cast<int>(i));
  }
  return chosen;
}

}  // namespace

Calibrated calibrate(const CombinedValues& held_out, const CalibrationSet& set,
                     double false_alarm_rate) {
  const int fold_count = static_cast<int>(set.folds.size());
  const std::vector<int> fold_of = testingFolds(set.folds, set.samples.size());

  Answers answers;
  for (int f = 0; f < fold_count; ++f) {
    const Calibration others =
        fit(held_out, set, validSamples(held_out, fold_of, f, false), false_alarm_rate);
    for (const int i : validSamples(held_out, fold_of, f, true)) {
      answers.add(held_out, i, set.samples[i].place, others, set.judges_unknown[i]);
    }
  }
  const std::size_t places = static_cast<std::size_t>(held_out.decision_values.cols());
  Calibrated calibrated;
  calibrated.calibration =
      fit(held_out, set, validSamples(held_out, fold_of, fold_count, false), false_alarm_rate);
  calibrated.unknown_threshold = quantile(answers.evidence, false_alarm_rate);
  constexpr double kLimit = 0.5;  // of evidence, by the definition of its fit
  if (!answers.evidence.empty()) {
    calibrated.unknown =
        static_cast<double>(std::count_if(answers.evidence.begin(), answers.evidence.end(),
                                          [](double evidence) { return evidence < kLimit; })) /
        static_cast<double>(answers.evidence.size());
  }
  calibrated.validation.average_rate = averageRate(answers.truth, answers.places, places);
  calibrated.validation.calibration_error = calibrationError(answers.confidences, answers.correct);
  return calibrated;
}

}  // namespace place_recognition
