#include "experiments/reduction_curve.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "learning/reduction.h"

namespace place_recognition {
namespace {

constexpr int kSteps = 50;
constexpr double kLowestShare = 0.7;

}  // namespace

ReductionCurve reductionCurve(const BinarySvms& machines, const Eigen::MatrixXd& kernel_values,
                              const std::string& method, bool normalize, const RateOf& rate) {
  const int all = static_cast<int>(supportVectors(machines).size());
  ReductionCurve curve{{all, rate(machines)}};
  if (all == 0) return curve;
  ReductionOptions options;
  options.method = method;
  options.normalize = normalize;
  options.support_vectors = all;
  const auto reduction = factorize(machines, kernel_values, options);
  for (int step = 1; step < kSteps; ++step) {
    const int count = all - all * step / kSteps;
    if (count == curve.back().vectors) continue;
    const BinarySvms reduced = reduction->withVectors(count);
    curve.push_back({static_cast<int>(supportVectors(reduced).size()), rate(reduced)});
    if (curve.back().rate < kLowestShare * curve.front().rate) break;
  }
  return curve;
}

int fewestVectors(const ReductionCurve& curve, double share) {
  constexpr double kRounding = 1e-9;
  int fewest = curve.front().vectors;
  for (const CurvePoint& point : curve) {
    const bool kept = point.rate >= share * curve.front().rate - kRounding;
    if (kept) fewest = std::min(fewest, point.vectors);
  }
  return fewest;
}

int fewestVectors(const std::vector<ReductionCurve>& curves, double share) {
  int fewest = fewestVectors(curves.front(), share);
  for (const ReductionCurve& curve : curves) fewest = std::min(fewest, fewestVectors(curve, share));
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
  for (const CurvePoint& point : curve) points.push_back({point.vectors, point.rate});
  return points;
}

ReductionCurve curveFromJson(const nlohmann::json& json) {
  ReductionCurve curve;
  for (const auto& point : json) curve.push_back({point.at(0), point.at(1)});
  return curve;
}

}  // namespace place_recognition
