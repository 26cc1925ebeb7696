#include <gtest/gtest.h>

#include <random>

#include "place_recognition/temporal_filter.h"

/// The filter's purpose, measured on simulated answers to the frames of a drive.
namespace place_recognition {
namespace {

constexpr int kRooms = 5;
constexpr double kRate = 5;   // frames per second
constexpr double kStay = 14;  // s in each room
constexpr double kWrong = 0.3;

struct Counts {
  int frames = 0, wrong = 0, filtered_wrong = 0;
  double slowest = 0;  // longest delay until a change of room was followed, s
};

/// Returns a uniform random number in low..high, the same on every platform.
double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

/// Returns the answer to a frame in `room`: randomly wrong, and less confident if wrong.
Recognition answerIn(int room, std::mt19937& random) {
  Recognition frame;
  const bool wrong = uniform(random, 0, 1) < kWrong;
  const int other = static_cast<int>(uniform(random, 1, kRooms));
  frame.place = wrong ? (room + other) % kRooms : room;
  frame.confidence = wrong ? uniform(random, 0.4, 0.8) : uniform(random, 0.5, 0.95);
  frame.probabilities.setConstant(kRooms, (1 - frame.confidence) / (kRooms - 1));
  frame.probabilities[frame.place] = frame.confidence;
  frame.evidence = uniform(random, 0.6, 1);
  frame.known = true;
  return frame;
}

/// Drives through the rooms in the order 0 1 2 3 4 3 2 1 0.
Counts drive(const Adjacency& adjacency, unsigned seed) {
  std::mt19937 random(seed);
  Model model;
  model.places.resize(kRooms);
  model.unknown_threshold = 0.5;
  TemporalFilter filter(model, adjacency, {});
  Counts counts;
  for (int visit = 0; visit < 2 * kRooms - 1; ++visit) {
    const int room = visit < kRooms ? visit : 2 * kRooms - 2 - visit;
    double followed = kStay;
    for (int i = 0; i < kStay * kRate; ++i) {
      const Recognition frame = answerIn(room, random);
      const FilteredAnswer& answer = filter.update(visit * kStay + i / kRate, frame);
      ++counts.frames;
      counts.wrong += frame.place != room;
      counts.filtered_wrong += answer.place != room;
      if (answer.place == room) followed = std::min(followed, i / kRate);
    }
    counts.slowest = std::max(counts.slowest, followed);
  }
  return counts;
}

class FilteredDrive : public testing::TestWithParam<bool> {};

TEST_P(FilteredDrive, HasAtMostHalfTheWrongFramesAndFollowsWithinTwoSeconds) {
  Adjacency adjacency(kRooms);
  const bool with_map = GetParam();
  for (int room = 0; with_map && room + 1 < kRooms; ++room) adjacency.join(room, room + 1);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Counts counts = drive(adjacency, seed);
    EXPECT_NEAR(static_cast<double>(counts.wrong) / counts.frames, kWrong, 0.1);
    EXPECT_LE(2 * counts.filtered_wrong, counts.wrong) << "seed " << seed;
    EXPECT_LE(counts.slowest, 2.0) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Map, FilteredDrive, testing::Bool(),
                         [](const auto& info) { return info.param ? "Known" : "Unknown"; });

}  // namespace
}  // namespace place_recognition
