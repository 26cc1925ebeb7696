#include "recognition/recognizer/evidence_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recognition/model/cue_mean.h"
#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

constexpr double kViewsBefore = 1;  // from the training, the prior of the drop
constexpr double kLargestShift = 4;
constexpr double kViewsOfStrangers = 2;  // prior of the ratio
constexpr double kStrangeRatio = 0.45;
constexpr double kKnownRatio = 0.55;

/// The lead of the largest decision value over the second, in standard deviations of all; 0 if they
/// are equal.
double leadOf(const Eigen::RowVectorXd& decision_values) {
  double first = -std::numeric_limits<double>::infinity();
  double second = first;
  for (Eigen::Index k = 0; k < decision_values.size(); ++k) {
    const double decision_value = decision_values[k];
    second = std::max(second, std::min(first, decision_value));
    first = std::max(first, decision_value);
  }
  const double deviation =
      std::sqrt((decision_values.array() - decision_values.mean()).square().mean());
  return deviation > 0 ? (first - second) / deviation : 0;
}

}  // namespace

EvidenceShift::EvidenceShift(const Model& model)
    : views_(static_cast<Eigen::Index>(model.places.size()), 2) {
  const auto places = static_cast<Eigen::Index>(model.places.size());
  const HeldOutFrames& frames = model.held_out;
  if (places < 3 || frames.places.empty()) return;
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(places, 3);  // log odds, leads, frames
  CueMean mean(model.decision_limit);
  for (std::size_t i = 0; i < frames.places.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    mean.begin(places);
    for (std::size_t c = 0; c < frames.decision_values.size(); ++c) {
      const double familiarity = frames.familiarity[c][row];
      if (std::isnan(familiarity)) continue;
      mean.add(model.cue_weights[c], frames.decision_values[c].row(row).cast<double>(),
               familiarity);
    }
    if (!mean.finish()) continue;
    sums.row(largest(mean.decisionValues())) +=
        Eigen::RowVector3d(model.calibration.logOdds(mean.unlimited(), mean.familiarity()),
                           leadOf(mean.unlimited()), 1);
  }
  const Eigen::RowVector3d all = sums.colwise().sum();
  if (!(all[1] > 0) || !all.allFinite()) return;
  for (Eigen::Index k = 0; k < places; ++k) {
    if (sums(k, 1) <= 0) sums.row(k) = all;
  }
  log_odds_ = sums.col(0).cwiseQuotient(sums.col(2));
  leads_ = sums.col(1).cwiseQuotient(sums.col(2));
}

void EvidenceShift::reset() { views_.reset(); }

void EvidenceShift::beginFrame(double stamp) { views_.beginFrame(stamp); }

void EvidenceShift::add(const Eigen::RowVectorXd& probabilities,
                        const Eigen::RowVectorXd& decision_values, double log_odds) {
  const double lead = leadOf(decision_values);
  if (log_odds_.size() == 0 || !std::isfinite(log_odds) || !std::isfinite(lead)) return;
  Eigen::MatrixXd values(log_odds_.size(), 2);
  values.col(0) = log_odds_.array() - log_odds;
  values.col(1) = lead / leads_.array();
  views_.add(probabilities, values);
}

double EvidenceShift::value() const {
  const double views = views_.views();
  const Eigen::RowVectorXd sums = views_.sums();
  const double ratio = (kViewsOfStrangers * kStrangeRatio + sums[1]) / (kViewsOfStrangers + views);
  const double known =
      std::clamp((ratio - kStrangeRatio) / (kKnownRatio - kStrangeRatio), 0.0, 1.0);
  return known * std::clamp(sums[0] / (kViewsBefore + views), 0.0, kLargestShift);
}

}  // namespace place_recognition
