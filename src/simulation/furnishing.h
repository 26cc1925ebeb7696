#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "simulation/furniture.h"
#include "simulation/simulation.h"

namespace place_recognition::simulation {

/// Places what stays where it is from one run to the next.
void furnish(Furniture& furniture);

/// Places what a condition and the weeks between two runs change: which lamps are on, blinds, door
/// leaves, chairs, screens, papers, mugs, boxes, people. Nothing of it comes near `keep_clear`.
void addChanges(Furniture& furniture, Condition condition,
                const std::vector<cv::Point2f>& keep_clear);

}  // namespace place_recognition::simulation
