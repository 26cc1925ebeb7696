#pragma once

#include <string>

#include "evaluation/evaluation.h"

namespace place_recognition {

/// One run from left to right as an <svg> element: the true place, the answer, and where it is
/// wrong; for a drive, the answers over time instead. 'unknown' is pale. Empty if the run has no
/// images.
std::string timelinePlot(const Evaluation& evaluation, int recording);

}  // namespace place_recognition
