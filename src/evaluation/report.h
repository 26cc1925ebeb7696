#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"

namespace place_recognition {

/// An evaluation as one HTML page that needs no other file: figures, plots, the confusion matrix,
/// and the images that were most confidently wrong.
std::string htmlReport(const Evaluation& evaluation, const Summary& summary);

}  // namespace place_recognition
