#pragma once

#include <string>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"

namespace place_recognition {

/// An evaluation as a self-contained HTML page: figures, plots, the confusion matrix, and the
/// images with the most confident errors.
std::string htmlReport(const Evaluation& evaluation, const Summary& summary);

}  // namespace place_recognition
