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
  double tau = 0;   ///< 0: before reduction
};

/// Columns dropped at this tau are linearly dependent on the others, up to rounding.
constexpr double kExactTau = 1e-9;

/// Points of increasing tau, the same for all machines, until the rate is below 70 % of that before
/// reduction (section 7.2): first kExactTau, then the values that drop the next 0.25 % of the
/// columns, or 1 % once a tenth is dropped.
using ReductionCurve = std::vector<CurvePoint>;

/// The rate of machines on the test sets, 0..1.
using RateOf = std::function<double(const BinarySvms&)>;

/// `kernel_values`: of all training vectors (rows) with the vectors of `machines`.
ReductionCurve reductionCurve(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                              const std::string& method, bool normalize, const RateOf& rate);

/// The point of a classifier reduced with `tau`: the last one whose tau is not larger. Null if the
/// curve ends before.
const CurvePoint* pointAt(const ReductionCurve& curve, double tau);

/// The fewest vectors among the points that keep `fraction` (0..1) of the first point's rate.
int fewestVectors(const ReductionCurve& curve, double fraction);

/// The same for several reductions of the same machines.
int fewestVectors(const std::vector<ReductionCurve>& curves, double fraction);

/// (fraction of the vectors left, rate) of the mean of several curves, as far as all of them
/// extend.
std::vector<std::pair<double, double>> meanCurve(const std::vector<ReductionCurve>& curves);

nlohmann::json toJson(const ReductionCurve& curve);
ReductionCurve curveFromJson(const nlohmann::json& json);

}  // namespace place_recognition
