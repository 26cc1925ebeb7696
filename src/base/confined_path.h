#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace place_recognition {

/// Whether `path` is `folder`, or in it; false if `folder` is empty. Both must be without links.
bool liesIn(const std::filesystem::path& path, const std::filesystem::path& folder);

/// The bag that `path`, received from the network, refers to: absolute, without links, and below
/// one of the folders `roots`. A relative path starts at a root, "~/" or "$HOME/" at the home
/// folder. Throws Error for anything else, with the same words whether such a file exists elsewhere
/// or not. The message says what the user can correct below a root: a bag that does not exist, with
/// the one that is probably meant, or a link that leads out of all roots.
std::string confinedBagPath(const std::string& path, const std::vector<std::string>& roots);

/// Default folders for bags: the home folder and ROS_HOME.
std::vector<std::string> defaultBagRoots();

}  // namespace place_recognition
