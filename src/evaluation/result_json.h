#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluation/evaluation.h"
#include "evaluation/summary.h"

namespace place_recognition {

/// The figures of an evaluation as JSON: average_rate, rooms, confusion, calibration_error,
/// support_vectors, model_bytes, latency_ms, and more. Rates and fractions are 0..1.
nlohmann::json resultJson(const Evaluation& evaluation, const Summary& summary);

}  // namespace place_recognition
