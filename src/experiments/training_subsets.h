#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/test_sets.h"

namespace place_recognition {

/// How `count` images of a room are selected.
enum class SubsetKind {
  kSpread,     ///< spread evenly over all of them, hence over all viewpoints
  kNeighbours  ///< successive ones from the middle of the room's images
};

/// At most `count` of `train` for each place, in order; `train` is in the order of the recording.
std::vector<int> subsetOf(const std::vector<int>& train, const SetSamples& samples, int count,
                          SubsetKind kind);

constexpr std::size_t kViewpointSamples = 12;  ///< angles of a marker of KTH-INDECS

/// kViewpointSamples successive samples of one place, or the rest of them.
struct Viewpoint {
  int place = 0;
  int number = 0;  ///< within the place, from 1
  std::vector<int> samples;
};

std::vector<Viewpoint> viewpointsOf(const std::vector<int>& train, const SetSamples& samples);

}  // namespace place_recognition
