#include "place_recognition/temporal_filter_options.h"

#include <cmath>

#include "base/require.h"

namespace place_recognition {
namespace {

void requirePositive(double value, const char* field) {
  requireOption(std::isfinite(value) && value > 0, field, value, "a number above 0");
}

void requireWithin(double value, const char* field, double low, double high, const char* range) {
  requireOption(value >= low && value <= high, field, value, range);
}

}  // namespace

void TemporalFilterOptions::check() const {
  requirePositive(dwell_time, "dwell_time");
  requirePositive(dwell_distance, "dwell_distance");
  requireWithin(unknown_share, "unknown_share", 0, 0.5, "a fraction, 0 to 0.5");
  requireWithin(jump_share, "jump_share", 0, 1, "a fraction, 0 to 1");
  requirePositive(decorrelation_time, "decorrelation_time");
  requirePositive(decorrelation_distance, "decorrelation_distance");
  requirePositive(decorrelation_angle, "decorrelation_angle");
  requireWithin(outlier_share, "outlier_share", 1e-4, 1, "a fraction, 0.0001 to 1");
  requireWithin(minimum_confidence, "minimum_confidence", 0, 1, "a probability, 0 to 1");
  requireWithin(minimum_dwell, "minimum_dwell", 0, 3600, "seconds, 0 to 3600");
  requirePositive(maximum_gap, "maximum_gap");
  requirePositive(camera_gap, "camera_gap");
}

}  // namespace place_recognition
