#include "experiments/reduction_curve.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "learning/reduction.h"

namespace place_recognition {
namespace {

constexpr double kLowestFraction = 0.7;

/// The same number of values, in ascending order, however many `thresholds` there are (see
/// Reduction).
std::vector<double> tausOf(const std::vector<double>& thresholds) {
  std::vector<double> taus = {kExactTau};
  const auto n = static_cast<double>(thresholds.size());
  for (int step = 1; step < 130; ++step) {
    const double dropped = step <= 40 ? 0.0025 * step : 0.1 + 0.01 * (step - 40);
    const auto kept = static_cast<std::size_t>(n - std::floor(dropped * n));
    if (kept < thresholds.size())
      taus.push_back(std::max(taus.back(), thresholds[kept]));
    else
      taus.push_back(taus.back());
  }
  return taus;
}

}  // namespace

ReductionCurve reductionCurve(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                              const std::string& method, bool normalize, const RateOf& rate) {
  const int all = static_cast<int>(supportVectors(machines).size());
  ReductionCurve curve{{all, rate(machines), 0}};
  if (all == 0) return curve;
  ReductionOptions options;
  options.method = method;
  options.normalize = normalize;
  options.support_vectors = all;
  const auto reduction = factorize(machines, kernel_values, options);
  for (const double tau : tausOf(reduction->thresholds())) {
    const BinarySvms reduced = reduction->withTau(tau);
    curve.push_back({static_cast<int>(supportVectors(reduced).size()), rate(reduced), tau});
    if (curve.back().rate < kLowestFraction * curve.front().rate) break;
  }
  return curve;
}

const CurvePoint* pointAt(const ReductionCurve& curve, double tau) {
  const CurvePoint* last = nullptr;
  for (const CurvePoint& point : curve) {
    if (point.tau <= tau) last = &point;
  }
  return last == &curve.back() && tau > last->tau ? nullptr : last;
}

int fewestVectors(const ReductionCurve& curve, double fraction) {
  constexpr double kRounding = 1e-9;
  int fewest = curve.front().vectors;
  for (const CurvePoint& point : curve) {
    const bool kept = point.rate >= fraction * curve.front().rate - kRounding;
    if (kept) fewest = std::min(fewest, point.vectors);
  }
  return fewest;
}

int fewestVectors(const std::vector<ReductionCurve>& curves, double fraction) {
  int fewest = fewestVectors(curves.front(), fraction);
  for (const ReductionCurve& curve : curves)
    fewest = std::min(fewest, fewestVectors(curve, fraction));
  return fewest;
}

std::vector<std::pair<double, double>> meanCurve(const std::vector<ReductionCurve>& curves) {
  std::vector<std::pair<double, double>> mean;
  std::size_t shortest = curves.empty() ? 0 : curves.front().size();
  for (const ReductionCurve& curve : curves) shortest = std::min(shortest, curve.size());
  const double n = static_cast<double>(curves.size());
  for (std::size_t i = 0; i < shortest; ++i) {
    auto& [left, rate] = mean.emplace_back(0, 0);
    for (const ReductionCurve& curve : curves) {
      left += static_cast<double>(curve[i].vectors) / std::max(1, curve[0].vectors) / n;
      rate += curve[i].rate / n;
    }
  }
  return mean;
}

nlohmann::json toJson(const ReductionCurve& curve) {
  nlohmann::json points = nlohmann::json::array();
  for (const CurvePoint& point : curve) points.push_back({point.vectors, point.rate, point.tau});
  return points;
}

ReductionCurve curveFromJson(const nlohmann::json& json) {
  ReductionCurve curve;
  for (const auto& point : json) curve.push_back({point.at(0), point.at(1), point.at(2)});
  return curve;
}

}  // namespace place_recognition
