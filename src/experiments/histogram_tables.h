#pragma once

#include <string>
#include <vector>

#include "experiments/experiment.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// The histograms to compare, and the corresponding table of the thesis.
enum class HistogramSweep {
  kDescriptors,  ///< Table 8.4: descriptors x combinations of one to four of the scales 1..5
  kBins,         ///< Table 8.5: 5 to 40 bins for seven combinations at the thesis' scales
};

/// The rates of one histogram.
struct HistogramResult {
  std::size_t row = 0;  ///< of the thesis' table
  CrfhOptions options;
  std::vector<std::vector<double>> rates;  ///< [training set][gamma], 0..1
};

/// Table 8.4 or 8.5: for each row of the thesis, the histogram and gamma with the highest rate,
/// averaged over the training sets.
Table histogramTable(HistogramSweep sweep, const std::vector<std::string>& sets,
                     const std::vector<double>& gammas,
                     const std::vector<HistogramResult>& histograms);

}  // namespace place_recognition
