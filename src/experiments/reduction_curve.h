#pragma once

#include <Eigen/Core>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "learning/binary_svms.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// A classifier after reduction to some number of vectors.
struct CurvePoint {
  int vectors = 0;
  double rate = 0;  ///< on the test sets, 0..1
};

/// Fewer and fewer vectors, from all of them in steps of two per cent, until the rate is below 70 %
/// of that of all (section 7.2). For method qr, all machines have the same tau at every point.
using ReductionCurve = std::vector<CurvePoint>;

/// The rate of machines on the test sets, 0..1.
using RateOf = std::function<double(const BinarySvms&)>;

/// `kernel_values`: of all training vectors (rows) and those of `machines`.
ReductionCurve reductionCurve(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                              const std::string& method, bool normalize, const RateOf& rate);

/// The fewest vectors of any point that keeps `share` (0..1) of the rate of the first one.
int fewestVectors(const ReductionCurve& curve, double share);

/// The same for several reductions of the same machines.
int fewestVectors(const std::vector<ReductionCurve>& curves, double share);

/// (share of the vectors left, rate) of the mean of several curves, as far as all of them go.
std::vector<std::pair<double, double>> meanCurve(const std::vector<ReductionCurve>& curves);

nlohmann::json toJson(const ReductionCurve& curve);
ReductionCurve curveFromJson(const nlohmann::json& json);

}  // namespace place_recognition
