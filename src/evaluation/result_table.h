#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"
#include "report/text_table.h"

namespace place_recognition {

/// How often answers of each tenth of confidence are right; the first row is the head.
TextRows reliabilityRows(const Summary& summary);

/// How many answers are wrong if only the most confident ones are given.
TextRows riskRows(const Summary& summary);

/// The figures of an evaluation as aligned text for a terminal: rates of the rooms and runs, their
/// mean, confusion matrix, calibration, risk against coverage, 'unknown', latency. Ends with a line
/// feed.
std::string resultTable(const Evaluation& evaluation, const Summary& summary);

}  // namespace place_recognition
