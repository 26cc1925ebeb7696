#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace place_recognition {

// Pure functions of answers. Every result is finite, and zero if there is nothing to measure.

/// One bin of a reliability table: frames whose confidence lies in [i, i + 1) tenths.
struct ReliabilityBin {
  std::uint64_t count = 0;
  double confidence = 0;  ///< mean
  double rate = 0;        ///< fraction of correct answers
};

/// The bins of confidence (see confidenceBin()) and the fraction of correct answers in each.
std::vector<ReliabilityBin> reliability(const std::vector<double>& confidences,
                                        const std::vector<bool>& correct);

/// Area under the ROC curve: the probability that a value drawn from `positive` is larger than one
/// drawn from `negative`; ties count half. 0.5 if either is empty.
double rocArea(const std::vector<double>& positive, const std::vector<double>& negative);

/// The fractions of positive and negative values below a threshold.
struct RocPoint {
  double positive_below = 0;
  double negative_below = 0;
};

/// One point per distinct value, from thresholds with no value below to thresholds with all.
std::vector<RocPoint> rocCurve(std::vector<double> positive, std::vector<double> negative);

/// If only the frames of highest confidence are answered: their fraction, and the fraction of wrong
/// answers among them.
struct RiskPoint {
  double coverage = 0;
  double risk = 0;
};

/// One point per distinct confidence, in ascending order of coverage up to 1.
std::vector<RiskPoint> riskCoverage(const std::vector<double>& confidences,
                                    const std::vector<bool>& correct);

/// The risk when at least `coverage` (0..1) of the frames are answered; 0 without frames.
double riskAt(const std::vector<RiskPoint>& points, double coverage);

/// Mean risk over all coverages: the area under the curve, as a step function.
double meanRisk(const std::vector<RiskPoint>& points);

}  // namespace place_recognition
