#include "recognition/scores.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace place_recognition {

double averageRate(const std::vector<int>& truth, const std::vector<int>& answers,
                   std::size_t places) {
  assert(truth.size() == answers.size());
  std::vector<double> right(places, 0), frames(places, 0);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    frames[truth[i]] += 1;
    right[truth[i]] += answers[i] == truth[i] ? 1 : 0;
  }
  double sum = 0;
  int rooms = 0;
  for (std::size_t k = 0; k < places; ++k) {
    if (frames[k] == 0) continue;
    sum += right[k] / frames[k];
    ++rooms;
  }
  return rooms == 0 ? 0 : sum / rooms;
}

double calibrationError(const std::vector<double>& confidences, const std::vector<bool>& correct) {
  assert(confidences.size() == correct.size());
  constexpr int kBins = 10;
  std::array<double, kBins> surplus{};  // correct answers less expected ones
  for (std::size_t i = 0; i < confidences.size(); ++i) {
    const int bin = std::clamp(static_cast<int>(confidences[i] * kBins), 0, kBins - 1);
    surplus[bin] += (correct[i] ? 1 : 0) - confidences[i];
  }
  double error = 0;
  for (const double bin : surplus) error += std::abs(bin);
  return confidences.empty() ? 0 : error / static_cast<double>(confidences.size());
}

}  // namespace place_recognition
