#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recognition/training/model_reduction.h"
#include "tool/output.h"

namespace place_recognition::tool {

/// Figures of a model before or after a reduction.
struct ReductionFigures {
  std::string method;  ///< `before` for the original model
  std::size_t support_vectors = 0;
  DecisionValueChange change;
  std::optional<double> rate;  ///< 0..1 on the validation runs, if there are any
  std::uint64_t model_bytes = 0;
  double comparison_ms = 0;  ///< see comparisonMilliseconds()
  /// Rate on the validation runs against the fraction of the vectors kept; may be empty.
  std::vector<std::pair<double, double>> curve;
};

/// The results of reductions of a model.
struct ReductionReport {
  std::string model;      ///< file of the reduced model
  std::string values_of;  ///< in words: the images on which changes of decision values are measured
  ReductionFigures before;                ///< the original model
  std::vector<ReductionFigures> methods;  ///< the saved one is first
  std::vector<std::string> warnings;      ///< for a person: skipped images
};

/// One line for the original model and one for each method, in aligned columns.
std::string reductionTable(const ReductionReport& report);

/// The figures of the saved method, and of all methods under `methods`.
Json reductionJson(const ReductionReport& report);

/// The table and, if there are validation runs, the curves as one HTML page.
std::string reductionPage(const ReductionReport& report);

}  // namespace place_recognition::tool
