#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recognition/training/model_reduction.h"
#include "tool/output.h"

namespace place_recognition::tool {

/// A model in figures, before or after a reduction.
struct ReductionFigures {
  std::string method;  ///< `before` for the model that was reduced
  std::size_t support_vectors = 0;
  DecisionValueChange change;
  std::optional<double> rate;  ///< 0..1 on the validation runs, if there are any
  std::uint64_t model_bytes = 0;
  double comparison_ms = 0;  ///< see comparisonMilliseconds()
  /// Rate on the validation runs against the fraction of the vectors kept; may be empty.
  std::vector<std::pair<double, double>> curve;
};

/// What reductions made of a model.
struct ReductionReport {
  std::string model;      ///< file of the reduced one
  std::string values_of;  ///< the images that changes of decision values are measured on, in words
  ReductionFigures before;                ///< the model as it was
  std::vector<ReductionFigures> methods;  ///< the one that was saved first
};

/// A line for the model as it was and one for each method, in aligned columns.
std::string reductionTable(const ReductionReport& report);

/// The figures of the method that was saved, and of all under `methods`.
Json reductionJson(const ReductionReport& report);

/// The table and, where there are validation runs, the curves as one HTML page.
std::string reductionPage(const ReductionReport& report);

}  // namespace place_recognition::tool
