#include "recognition/model/scores.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace place_recognition {

namespace {

/// First and second moment of one room's values.
struct Moments {
  double sum = 0;
  double squares = 0;
  double count = 0;

  double mean() const { return sum / count; }
  double varianceOfMean() const { return std::max(0.0, squares / count - mean() * mean()) / count; }
};

/// One if the answer is right, else zero.
std::vector<double> hits(const std::vector<int>& truth, const std::vector<int>& answers) {
  assert(truth.size() == answers.size());
  std::vector<double> values(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) values[i] = answers[i] == truth[i] ? 1 : 0;
  return values;
}

}  // namespace

RoomMean roomMean(const std::vector<int>& truth, const std::vector<double>& values,
                  std::size_t places) {
  assert(truth.size() == values.size());
  std::vector<Moments> rooms(places);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    Moments& room = rooms[static_cast<std::size_t>(truth[i])];
    room.sum += values[i];
    room.squares += values[i] * values[i];
    room.count += 1;
  }
  double sum = 0;
  double variance = 0;
  double occurring = 0;
  for (const Moments& room : rooms) {
    if (room.count == 0) continue;
    sum += room.mean();
    variance += room.varianceOfMean();
    occurring += 1;
  }
  if (occurring == 0) return {};
  return {sum / occurring, std::sqrt(variance) / occurring};
}

RoomMean roomRates(const std::vector<int>& truth, const std::vector<int>& answers,
                   std::size_t places) {
  return roomMean(truth, hits(truth, answers), places);
}

double averageRate(const std::vector<int>& truth, const std::vector<int>& answers,
                   std::size_t places) {
  return roomRates(truth, answers, places).mean;
}

std::vector<ConfusedPair> confusedPairs(const std::vector<int>& truth,
                                        const std::vector<int>& answers, std::size_t places) {
  assert(truth.size() == answers.size());
  std::vector<double> frames(places, 0);
  std::map<std::pair<int, int>, double> confusions;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    frames[static_cast<std::size_t>(truth[i])] += 1;
    if (answers[i] < 0 || answers[i] == truth[i]) continue;
    confusions[std::minmax(truth[i], answers[i])] += 1;
  }
  std::vector<ConfusedPair> pairs;
  for (const auto& [places_of_pair, count] : confusions) {
    const auto [a, b] = places_of_pair;
    const double both = frames[static_cast<std::size_t>(a)] + frames[static_cast<std::size_t>(b)];
    const double rate = count / both;
    pairs.push_back({a, b, rate, std::sqrt(rate * (1 - rate) / both)});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& left, const auto& right) { return left.rate > right.rate; });
  return pairs;
}

int confidenceBin(double confidence) {
  return std::clamp(static_cast<int>(confidence * kConfidenceBins), 0, kConfidenceBins - 1);
}

double calibrationError(const std::vector<double>& confidences, const std::vector<bool>& correct) {
  assert(confidences.size() == correct.size());
  std::array<double, kConfidenceBins> surplus{};  // correct answers minus expected ones
  for (std::size_t i = 0; i < confidences.size(); ++i) {
    surplus[confidenceBin(confidences[i])] += (correct[i] ? 1 : 0) - confidences[i];
  }
  double error = 0;
  for (const double bin : surplus) error += std::abs(bin);
  return confidences.empty() ? 0 : error / static_cast<double>(confidences.size());
}

}  // namespace place_recognition
