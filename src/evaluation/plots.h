#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"

namespace place_recognition {

// The figures of the report, each an <svg> element.

/// One bar per room: the fraction of correct answers; a line marks the mean.
std::string ratesPlot(const Summary& summary);

/// Fraction of correct answers against confidence.
std::string reliabilityPlot(const Summary& summary);

/// Histogram of confidence in learned places, for correct and wrong answers.
std::string confidencePlot(const Evaluation& evaluation);

/// Fraction of wrong answers if only the most confident ones are given.
std::string riskPlot(const Summary& summary);

/// Fraction of images of unknown places detected by a threshold, against the fraction of known ones
/// answered 'unknown'.
std::string rocPlot(const UnknownSummary& unknown);

}  // namespace place_recognition
