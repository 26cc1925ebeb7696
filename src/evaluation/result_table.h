#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"
#include "report/text_table.h"

namespace place_recognition {

/// Fraction of correct answers for each tenth of confidence; the first row is the header.
TextRows reliabilityRows(const Summary& summary);

/// Fraction of wrong answers if only the most confident ones are given.
TextRows riskRows(const Summary& summary);

/// The figures of an evaluation as aligned text for a terminal: rates of rooms and runs, their
/// mean, confusion matrix, calibration, risk against coverage, 'unknown', latency. Ends with a
/// newline.
std::string resultTable(const Evaluation& evaluation, const Summary& summary);

}  // namespace place_recognition
