#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"

namespace place_recognition {

/// The figures of an evaluation as aligned text for a terminal: rates of the rooms and runs, their
/// mean, confusion matrix, calibration, 'unknown', latency. Ends with a line feed.
std::string resultTable(const Evaluation& evaluation, const Summary& summary);

}  // namespace place_recognition
