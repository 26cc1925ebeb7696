#pragma once

#include <string>

namespace place_recognition {

// Location of the objects to which users refer by name: models and networks.

/// $ROS_HOME/place_recognition/KIND, or ~/.ros/place_recognition/KIND. Throws Error if neither
/// ROS_HOME nor HOME is set.
std::string dataFolder(const std::string& kind);

/// Whether `name` matches [A-Za-z0-9_-]{1,64}, as required for models, networks and cues: their
/// names become parts of paths and of option keys.
bool isPlainName(const std::string& name);

/// Whether `name` is a file name rather than the name of an object in its dataFolder(): it contains
/// a slash or ends in `extension`.
bool isFileName(const std::string& name, const std::string& extension);

}  // namespace place_recognition
