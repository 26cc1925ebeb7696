#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "simulation/furniture.h"
#include "simulation/simulation.h"

namespace place_recognition::simulation {

/// Places what stays the same from one run to the next.
void furnish(Furniture& furniture);

/// Places what depends on the condition and on the weeks between two runs: lamps that are on,
/// blinds, door leaves, chairs, screens, papers, mugs, boxes, people. Keeps all of it away from
/// `keep_clear`.
void addChanges(Furniture& furniture, Condition condition,
                const std::vector<cv::Point2f>& keep_clear);

}  // namespace place_recognition::simulation
