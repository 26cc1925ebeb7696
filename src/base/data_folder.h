#pragma once

#include <string>

namespace place_recognition {

// Location of the objects to which users refer by name: models and networks.

/// $ROS_HOME/place_recognition/KIND, or ~/.ros/place_recognition/KIND. Throws Error if neither
/// ROS_HOME nor HOME is set.
std::string dataFolder(const std::string& kind);

/// Whether `name` consists of 1 to 64 of A-Z, a-z, 0-9, _ and -, and does not start with -, as
/// required for models, networks and cues: their names become parts of paths and of option keys,
/// and words of command lines.
bool isPlainName(const std::string& name);

/// That rule, for messages.
constexpr const char* kPlainNameRule =
    "1 to 64 letters, digits, '_' or '-', and no '-' at its start";

/// Whether `name` is a file name rather than the name of an object in its dataFolder(): it contains
/// a slash or ends in `extension`.
bool isFileName(const std::string& name, const std::string& extension);

}  // namespace place_recognition
