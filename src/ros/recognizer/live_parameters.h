#pragma once

#include <place_recognition/PlaceRecognizerConfig.h>
#include <ros/ros.h>

#include "ros/nodes/parameters.h"

namespace place_recognition {

// The parameters that dynamic_reconfigure can change.

/// Reads them at the start and sets them as they were understood, because dynamic_reconfigure
/// silently replaces values that it does not understand by the default and clamps others to their
/// limits. Throws Error for both.
void checkLiveParameters(Parameters& parameters, const ros::NodeHandle& private_node);

/// Replaces values that are not a number, which no limit excludes, by those of `before`, and logs
/// them.
void keepNumbers(PlaceRecognizerConfig& config, const PlaceRecognizerConfig& before);

}  // namespace place_recognition
