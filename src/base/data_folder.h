#pragma once

#include <string>

namespace place_recognition {

// Where things live that users refer to by name: models, networks.

/// $ROS_HOME/place_recognition/KIND, or ~/.ros/place_recognition/KIND. Throws Error if neither
/// ROS_HOME nor HOME is set.
std::string dataFolder(const std::string& kind);

/// Whether `name` is [A-Za-z0-9_-]{1,64}: models, networks and cues, whose names become parts of
/// paths and of option keys.
bool isPlainName(const std::string& name);

/// Whether `name` names a file rather than a thing in its dataFolder(): it has a slash or ends in
/// `extension`.
bool isFileName(const std::string& name, const std::string& extension);

/// A name from anywhere, fit to stand in a message.
std::string quoted(const std::string& name);

}  // namespace place_recognition
