#pragma once

#include <string>

namespace place_recognition {

/// The absolute path that a person means by `path`: "~/" is the home folder, "~name/" that of
/// another user, "$NAME/" or "${NAME}/" an environment variable. A relative path starts at the
/// folder in which the person called the program; for a node started by roslaunch, this is the
/// folder in which roslaunch was called, although the node itself starts in $ROS_HOME. Blanks and
/// other characters are kept; a leading "file://" is dropped. Empty stays empty. Throws Error for
/// the home folder of a user that does not exist, and for a variable that is not set.
std::string userPath(const std::string& path);

}  // namespace place_recognition
