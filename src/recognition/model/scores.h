#pragma once

#include <cstddef>
#include <vector>

namespace place_recognition {

/// The place with the largest value; of equal values, the first.
template <typename Row>
int largest(const Row& values) {
  int place = 0;
  for (int k = 1; k < static_cast<int>(values.size()); ++k) {
    if (values[k] > values[place]) place = k;
  }
  return place;
}

/// A mean over rooms, with equal weight per room regardless of its number of frames.
struct RoomMean {
  double mean = 0;
  double standard_error = 0;  ///< of the mean, as if frames were independent
};

/// Mean of the rooms' means of `values`, over the rooms that occur in `truth`; 0 if none does.
RoomMean roomMean(const std::vector<int>& truth, const std::vector<double>& values,
                  std::size_t places);

/// Mean of the rooms' rates with equal weight per room (thesis section 8.1), over the rooms that
/// occur in `truth`; 0 if none does. `answers`: the place answered for each frame, -1 for none.
RoomMean roomRates(const std::vector<int>& truth, const std::vector<int>& answers,
                   std::size_t places);

/// The mean of roomRates().
double averageRate(const std::vector<int>& truth, const std::vector<int>& answers,
                   std::size_t places);

/// Two places that are confused with one another.
struct ConfusedPair {
  int a = 0, b = 0;  ///< a < b
  double rate = 0;   ///< fraction of the frames of both that are answered with the other one
  double standard_error = 0;  ///< of the rate, as if frames were independent
};

/// All confused pairs, the most confused first. Arguments as for roomRates().
std::vector<ConfusedPair> confusedPairs(const std::vector<int>& truth,
                                        const std::vector<int>& answers, std::size_t places);

/// Number of equal bins of confidence, and the bin of a confidence 0..1.
constexpr int kConfidenceBins = 10;
int confidenceBin(double confidence);

/// Expected calibration error: the mean of |fraction of correct answers - mean confidence| over the
/// bins of confidence, weighted by their frames. 0 without frames.
double calibrationError(const std::vector<double>& confidences, const std::vector<bool>& correct);

}  // namespace place_recognition
