#pragma once

#include <cstdint>
#include <memory>

#include "place_recognition/recording.h"

namespace place_recognition {

/// One in `step` labelled frames of each place of `recording`, see StratifiedStream. It always
/// includes the first frame of a place.
std::unique_ptr<Recording> thinOut(std::unique_ptr<Recording> recording, std::size_t step,
                                   std::uint64_t seed);

}  // namespace place_recognition
