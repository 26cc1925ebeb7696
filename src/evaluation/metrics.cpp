#include "evaluation/metrics.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "recognition/model/scores.h"

namespace place_recognition {

std::vector<ReliabilityBin> reliability(const std::vector<double>& confidences,
                                        const std::vector<bool>& correct) {
  assert(confidences.size() == correct.size());
  std::vector<ReliabilityBin> bins(kConfidenceBins);
  for (std::size_t i = 0; i < confidences.size(); ++i) {
    ReliabilityBin& bin = bins[confidenceBin(confidences[i])];
    ++bin.count;
    bin.confidence += confidences[i];
    bin.rate += correct[i] ? 1 : 0;
  }
  for (ReliabilityBin& bin : bins) {
    if (bin.count == 0) continue;
    bin.confidence /= static_cast<double>(bin.count);
    bin.rate /= static_cast<double>(bin.count);
  }
  return bins;
}

double rocArea(const std::vector<double>& positive, const std::vector<double>& negative) {
  if (positive.empty() || negative.empty()) return 0.5;
  std::vector<double> sorted = negative;
  std::sort(sorted.begin(), sorted.end());
  double wins = 0;
  for (const double value : positive) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    wins += static_cast<double>(first - sorted.begin()) + 0.5 * static_cast<double>(last - first);
  }
  return wins / (static_cast<double>(positive.size()) * static_cast<double>(negative.size()));
}

std::vector<RocPoint> rocCurve(std::vector<double> positive, std::vector<double> negative) {
  std::sort(positive.begin(), positive.end());
  std::sort(negative.begin(), negative.end());
  std::vector<RocPoint> points{{0, 0}};
  std::size_t p = 0, n = 0;
  while (p < positive.size() || n < negative.size()) {
    const bool next_is_positive =
        n == negative.size() || (p < positive.size() && positive[p] <= negative[n]);
    const double value = next_is_positive ? positive[p] : negative[n];
    while (p < positive.size() && positive[p] == value) ++p;
    while (n < negative.size() && negative[n] == value) ++n;
    points.push_back({positive.empty() ? 0 : static_cast<double>(p) / positive.size(),
                      negative.empty() ? 0 : static_cast<double>(n) / negative.size()});
  }
  return points;
}

std::vector<RiskPoint> riskCoverage(const std::vector<double>& confidences,
                                    const std::vector<bool>& correct) {
  assert(confidences.size() == correct.size());
  std::vector<std::size_t> order(confidences.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return confidences[a] > confidences[b]; });
  std::vector<RiskPoint> points;
  double wrong = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    wrong += correct[order[i]] ? 0 : 1;
    const bool tied = i + 1 < order.size() && confidences[order[i + 1]] == confidences[order[i]];
    if (tied) continue;
    const double answered = static_cast<double>(i + 1);
    points.push_back({answered / static_cast<double>(order.size()), wrong / answered});
  }
  return points;
}

double riskAt(const std::vector<RiskPoint>& points, double coverage) {
  const auto found = std::find_if(points.begin(), points.end(), [coverage](const RiskPoint& point) {
    return point.coverage >= coverage - 1e-9;
  });
  return found == points.end() ? 0 : found->risk;
}

double meanRisk(const std::vector<RiskPoint>& points) {
  double area = 0, previous = 0;
  for (const RiskPoint& point : points) {
    area += (point.coverage - previous) * point.risk;
    previous = point.coverage;
  }
  return area;
}

}  // namespace place_recognition
