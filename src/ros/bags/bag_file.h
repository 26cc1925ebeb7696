#pragma once

#include <string>

namespace place_recognition {

/// Whether `path` is meant as a ROS 1 bag: by its name, which ends in .bag or, while it is being
/// recorded, .bag.active (in any case), or by what it starts with.
bool isBag(const std::string& path);

/// Whether a recorder that was killed, or still records, has left the bag under this name.
bool isActiveBag(const std::string& path);

/// What is the matter with an active bag at `path` that has no index, and what to do, behind "PATH:
/// ", without a full stop.
std::string whyActive(const std::string& path);

/// Whether the folder is a bag of ROS 2.
bool isRos2Bag(const std::string& folder);

/// Throws Error, saying what is there instead, unless `path` can be read and starts as a bag does.
void requireBag(const std::string& path);

/// What is wrong with a file or folder that was given for a recording and is none that can be read:
/// what it is and what to do, behind "PATH is ", without a full stop; empty if nothing is known.
std::string whyNoRecording(const std::string& path);

}  // namespace place_recognition
