#include "simulation/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <vector>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

SimulationOptions small(Condition condition) {
  SimulationOptions options;
  options.condition = condition;
  options.size = {64, 48};
  return options;
}

/// Returns the first `count` frames of a recording.
std::vector<SimulatedFrame> firstFrames(const SimulationOptions& options, std::size_t count) {
  std::vector<SimulatedFrame> frames;
  simulate(options, [&](const SimulatedFrame& frame, std::size_t, std::size_t) {
    frames.push_back(frame);
    frames.back().image = frame.image.clone();
    return frames.size() < count;
  });
  return frames;
}

bool sameImages(const std::vector<SimulatedFrame>& a, const std::vector<SimulatedFrame>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (cv::norm(a[i].image, b[i].image, cv::NORM_INF) > 0.0) return false;
  }
  return a.size() == b.size();
}

TEST(Simulation, SameSeedSamePixelsWhateverTheNumberOfThreads) {
  SimulationOptions options = small(Condition::kSunny);
  options.threads = 1;
  const auto one = firstFrames(options, 12);
  options.threads = 2;
  ASSERT_EQ(one.size(), 12u);
  EXPECT_TRUE(sameImages(one, firstFrames(options, 12)));
  options.seed = 2;
  EXPECT_FALSE(sameImages(one, firstFrames(options, 12)));
}

TEST(Simulation, EachFloorIsTheBuildingOfTheNextSeed) {
  SimulationOptions options = small(Condition::kCloudy);
  options.protocol = Protocol::kDrive;
  options.rate = 0.5;
  const auto frames = firstFrames(options, 1000);
  options.floors = 2;
  const auto both = firstFrames(options, 1000);
  options.floors = 1;
  options.seed = 2;
  auto expected = frames;
  for (const SimulatedFrame& frame : firstFrames(options, 1000)) expected.push_back(frame);

  EXPECT_TRUE(sameImages(both, expected));
  ASSERT_EQ(both.size(), expected.size());
  double last = -1.0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    const std::string prefix = i < frames.size() ? "floor1_" : "floor2_";
    EXPECT_EQ(both[i].room, prefix + expected[i].room);
    EXPECT_EQ(both[i].name, prefix + expected[i].name);
    EXPECT_GT(both[i].stamp, last);
    last = both[i].stamp;
  }
}

TEST(Simulation, AnotherVisitIsToTheSameBuildingOnAnotherDay) {
  SimulationOptions options = small(Condition::kNight);  // all lamps are on, whatever the day
  const auto first = firstFrames(options, 12);
  options.visit = 2;
  const auto second = firstFrames(options, 12);
  EXPECT_FALSE(sameImages(first, second));
  options.seed = 2;
  const auto elsewhere = firstFrames(options, 12);
  double moved = 0, another = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    moved += cv::norm(first[i].image, second[i].image, cv::NORM_L1);
    another += cv::norm(first[i].image, elsewhere[i].image, cv::NORM_L1);
  }
  EXPECT_LT(moved, 0.7 * another);
}

TEST(Simulation, CamerasOfOneRobotLookTheirWayAtEachMoment) {
  SimulationOptions options = small(Condition::kNight);
  const auto alone = firstFrames(options, 12);
  options.cameras = {"rear", "front"};
  const auto both = firstFrames(options, 24);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const SimulatedFrame& rear = both[2 * i];
    const SimulatedFrame& front = both[2 * i + 1];
    EXPECT_EQ(rear.camera, "rear");
    EXPECT_EQ(front.camera, "front");
    EXPECT_EQ(rear.stamp, alone[i].stamp);
    EXPECT_EQ(rear.room, front.room);
    EXPECT_TRUE(sameImages({front}, {alone[i]}));
  }
  // A tripod turns through twelve angles: its rear view equals the front view six images later.
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<double> differences;
    for (const SimulatedFrame& ahead : alone) {
      differences.push_back(cv::norm(both[2 * i].image, ahead.image, cv::NORM_L1));
    }
    const auto least = std::min_element(differences.begin(), differences.end());
    EXPECT_EQ(least - differences.begin(), static_cast<std::ptrdiff_t>(i) + 6);
  }
}

TEST(Simulation, EachConditionGivesItsOwnWellExposedImages) {
  std::vector<std::vector<SimulatedFrame>> recordings;
  for (const Condition condition : {Condition::kCloudy, Condition::kNight, Condition::kSunny}) {
    recordings.push_back(firstFrames(small(condition), 24));
    double sum = 0.0;
    for (const SimulatedFrame& frame : recordings.back()) {
      ASSERT_EQ(frame.image.type(), CV_8UC3);
      ASSERT_EQ(frame.image.size(), cv::Size(64, 48));
      const cv::Scalar mean = cv::mean(frame.image);
      sum += (mean[0] + mean[1] + mean[2]) / 3.0;
    }
    EXPECT_GT(sum / 24.0, 60.0) << name(condition);
    EXPECT_LT(sum / 24.0, 160.0) << name(condition);
  }
  EXPECT_FALSE(sameImages(recordings[0], recordings[1]));
  EXPECT_FALSE(sameImages(recordings[0], recordings[2]));
}

TEST(Simulation, IndecsTakesTwelveImagesAtEveryMarkerOfFiveRooms) {
  SimulationOptions options = small(Condition::kNight);
  options.size = {16, 16};
  std::map<std::string, int> pictures;  // of each room_marker
  std::set<std::string> names, rooms;
  std::size_t expected = 0;
  double last = -1.0;
  const std::regex pattern("(office_a|office_b|kitchen|corridor|printer_area)_[0-9]{2}_[0-9]{3}");
  simulate(options, [&](const SimulatedFrame& frame, std::size_t index, std::size_t count) {
    EXPECT_TRUE(std::regex_match(frame.name, pattern)) << frame.name;
    EXPECT_EQ(frame.name.rfind(frame.room + "_", 0), 0u) << frame.name;
    EXPECT_EQ(index, names.size());
    EXPECT_GT(frame.stamp, last);
    last = frame.stamp;
    expected = count;
    names.insert(frame.name);
    rooms.insert(frame.room);
    ++pictures[frame.name.substr(0, frame.name.size() - 4)];
    return true;
  });
  EXPECT_EQ(names.size(), expected);
  EXPECT_EQ(rooms.size(), 5u);
  EXPECT_GE(pictures.size(), 40u);
  EXPECT_LE(pictures.size(), 60u);
  for (const auto& [marker, count] : pictures) EXPECT_EQ(count, 12) << marker;
}

TEST(Simulation, TheSinkStopsTheRun) {
  SimulationOptions options = small(Condition::kNight);
  options.size = {16, 16};
  EXPECT_EQ(firstFrames(options, 3).size(), 3u);
}

TEST(Simulation, NamesGoThereAndBack) {
  for (const char* text : {"cloudy", "night", "sunny"}) {
    EXPECT_STREQ(name(conditionFromName(text)), text);
  }
  for (const char* text : {"indecs", "drive"}) EXPECT_STREQ(name(protocolFromName(text)), text);
  EXPECT_THROW(conditionFromName("foggy"), Error);
  EXPECT_THROW(protocolFromName(""), Error);
}

TEST(Simulation, OptionsOutOfRangeAreRefused) {
  SimulationOptions options;
  EXPECT_NO_THROW(options.check());
  options.size = {512, 8};
  EXPECT_THROW(options.check(), Error);
  options = {};
  options.visit = 0;
  EXPECT_THROW(options.check(), Error);
  options = {};
  options.floors = 0;
  EXPECT_THROW(options.check(), Error);
  options = {};
  options.rate = 0.0;
  EXPECT_THROW(simulate(options, [](const auto&, std::size_t, std::size_t) { return true; }),
               Error);
  options = {};
  for (const char* second : {"front", "up", ""}) {
    options.cameras = {"front", second};
    EXPECT_THROW(options.check(), Error) << second;
  }
}

}  // namespace
}  // namespace place_recognition
