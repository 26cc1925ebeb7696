#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// The bag that `path`, which comes from the network, names: absolute, without links, and below one
/// of the folders `roots`. A relative path starts at a root, "~/" or "$HOME/" at the home folder.
/// Throws Error for anything else, in the same words whether there is such a file elsewhere or not.
/// Where a link below a root leads out of all of them, the message says so, for that the user can
/// mend.
std::string confinedBagPath(const std::string& path, const std::vector<std::string>& roots);

/// Where bags may lie unless told otherwise: the home folder and ROS_HOME.
std::vector<std::string> defaultBagRoots();

}  // namespace place_recognition
