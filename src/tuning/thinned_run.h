#pragma once

#include <memory>

#include "place_recognition/run.h"

namespace place_recognition {

/// Every `step`-th labelled frame of each place of `run`. The first frame of a place is always
/// among them.
std::unique_ptr<Run> thinOut(std::unique_ptr<Run> run, std::size_t step);

}  // namespace place_recognition
