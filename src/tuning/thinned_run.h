#pragma once

#include <cstdint>
#include <memory>

#include "place_recognition/run.h"

namespace place_recognition {

/// One of every `step` labelled frames of each place of `run`, see StratifiedStream. The first
/// frame of a place is always among them.
std::unique_ptr<Run> thinOut(std::unique_ptr<Run> run, std::size_t step, std::uint64_t seed);

}  // namespace place_recognition
