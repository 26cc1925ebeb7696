#pragma once

#include <memory>

#include "place_recognition/run.h"
#include "tuning/light.h"

namespace place_recognition {

/// Every `step`-th labelled frame of each place of `run`, its image in another light. The first
/// frame of a place is always among them.
std::unique_ptr<Run> thinOut(std::unique_ptr<Run> run, std::size_t step, const Light& light);

}  // namespace place_recognition
