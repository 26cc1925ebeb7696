#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace place_recognition {

// Pure functions of answers; every result is finite, and zero where there is nothing to measure.

/// One bin of a reliability table: frames whose confidence lies in [i, i + 1) tenths.
struct ReliabilityBin {
  std::uint64_t count = 0;
  double confidence = 0;  ///< mean
  double rate = 0;        ///< fraction of correct answers
};

/// Ten bins of confidence (0..1) and how often the answers in each were correct.
std::vector<ReliabilityBin> reliability(const std::vector<double>& confidences,
                                        const std::vector<bool>& correct);

/// Area under the ROC curve: the chance that a value drawn from `positive` is larger than one
/// drawn from `negative`, ties counting half. 0.5 if either is empty.
double rocArea(const std::vector<double>& positive, const std::vector<double>& negative);

/// A threshold between the values of two kinds: what fraction of each kind lies below it.
struct RocPoint {
  double positive_below = 0;
  double negative_below = 0;
};

/// From no value below to all: one point for each distinct value.
std::vector<RocPoint> rocCurve(std::vector<double> positive, std::vector<double> negative);

/// If only the frames of highest confidence were answered: what fraction that is, and what fraction
/// of those answers is wrong.
struct RiskPoint {
  double coverage = 0;
  double risk = 0;
};

/// One point for each distinct confidence, coverage ascending to 1.
std::vector<RiskPoint> riskCoverage(const std::vector<double>& confidences,
                                    const std::vector<bool>& correct);

/// The risk where at least `coverage` (0..1) of the frames are answered; 0 without frames.
double riskAt(const std::vector<RiskPoint>& points, double coverage);

/// Mean risk over all coverages: the area under that curve, as steps.
double meanRisk(const std::vector<RiskPoint>& points);

/// The smallest value that at least `fraction` (0..1) of the values do not exceed (nearest rank).
double percentile(std::vector<double> values, double fraction);

}  // namespace place_recognition
