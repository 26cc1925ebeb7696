// Rendered omnidirectional images: the mirror is found, and the image unrolls to the surroundings.

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "recognition/frames/mirror_search.h"
#include "recognition/frames/panorama.h"
#include "simulation/omni_renderer.h"
#include "simulation/simulation.h"

namespace place_recognition {
namespace {

std::vector<SimulatedFrame> omniFrames(Condition condition, cv::Size size, std::size_t count) {
  SimulationOptions options;
  options.condition = condition;
  options.protocol = Protocol::kDrive;
  options.size = size;
  options.rate = 0.1;
  options.omnidirectional = true;
  std::vector<SimulatedFrame> frames;
  simulate(options, [&](const SimulatedFrame& frame, std::size_t, std::size_t) {
    frames.push_back(frame);
    return frames.size() < count;
  });
  return frames;
}

TEST(OmniPictures, TellWhereTheirMirrorIs) {
  for (const Condition condition : {Condition::kCloudy, Condition::kNight}) {
    const cv::Size size(240, 180);
    const simulation::MirrorRing expected = simulation::mirrorRing(size);
    for (const SimulatedFrame& frame : omniFrames(condition, size, 4)) {
      const auto ring = findMirror(frame.image);
      ASSERT_TRUE(ring) << frame.name;
      EXPECT_NEAR(ring->center.x, expected.center.x, 2);
      EXPECT_NEAR(ring->center.y, expected.center.y, 2);
      EXPECT_NEAR(ring->outer, expected.outer, 2);
      EXPECT_NEAR(ring->inner, expected.inner, 4);
    }
  }
}

}  // namespace
}  // namespace place_recognition
