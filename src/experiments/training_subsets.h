#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/test_sets.h"

namespace place_recognition {

/// How `count` images of a room are chosen of all.
enum class SubsetKind {
  kSpread,     ///< evenly over all of them, so over all viewpoints
  kNeighbours  ///< successive ones, from the middle of the room's
};

/// At most `count` of `train` for each place, in order; `train` in the order of the recording.
std::vector<int> subsetOf(const std::vector<int>& train, const SetSamples& samples, int count,
                          SubsetKind kind);

constexpr std::size_t kViewpointSamples = 12;  ///< angles of a marker of KTH-INDECS

/// As many successive samples of one place, or what is left of them.
struct Viewpoint {
  int place = 0;
  int number = 0;  ///< within the place, from 1
  std::vector<int> samples;
};

std::vector<Viewpoint> viewpointsOf(const std::vector<int>& train, const SetSamples& samples);

}  // namespace place_recognition
