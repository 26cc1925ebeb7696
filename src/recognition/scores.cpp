#include "recognition/scores.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace place_recognition {

namespace {

/// Right answers and frames of one room.
struct Tally {
  double right = 0;
  double frames = 0;
  double rate() const { return right / frames; }
};

/// Of the rooms that occur.
std::vector<Tally> tallies(const std::vector<int>& truth, const std::vector<int>& answers,
                           std::size_t places) {
  assert(truth.size() == answers.size());
  std::vector<Tally> rooms(places);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    rooms[truth[i]].frames += 1;
    rooms[truth[i]].right += answers[i] == truth[i] ? 1 : 0;
  }
  const auto absent = [](const Tally& room) { return room.frames == 0; };
  rooms.erase(std::remove_if(rooms.begin(), rooms.end(), absent), rooms.end());
  return rooms;
}

}  // namespace

double averageRate(const std::vector<int>& truth, const std::vector<int>& answers,
                   std::size_t places) {
  const std::vector<Tally> rooms = tallies(truth, answers, places);
  double sum = 0;
  for (const Tally& room : rooms) sum += room.rate();
  return rooms.empty() ? 0 : sum / static_cast<double>(rooms.size());
}

double averageRateError(const std::vector<int>& truth, const std::vector<int>& answers,
                        std::size_t places) {
  const std::vector<Tally> rooms = tallies(truth, answers, places);
  double variance = 0;
  for (const Tally& room : rooms) variance += room.rate() * (1 - room.rate()) / room.frames;
  return rooms.empty() ? 0 : std::sqrt(variance) / static_cast<double>(rooms.size());
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
