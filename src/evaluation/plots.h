#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"

namespace place_recognition {

// The figures of the report, each an <svg> element.

/// A bar per room: the fraction answered right; a line marks the mean.
std::string ratesPlot(const Summary& summary);

/// How often answers of a certain confidence are right, against that confidence.
std::string reliabilityPlot(const Summary& summary);

/// How many images were answered with which confidence, right and wrong ones.
std::string confidencePlot(const Evaluation& evaluation);

/// Fraction of wrong answers if only the most confident ones were given.
std::string riskPlot(const Summary& summary);

/// Fraction of places never learned that a threshold finds, against the known ones it calls
/// unknown.
std::string rocPlot(const UnknownSummary& unknown);

}  // namespace place_recognition
