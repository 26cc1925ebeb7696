#pragma once

#include <ros/master.h>

#include <string>

namespace place_recognition {

/// Why no image may come on `topic` (without /compressed) by the image transport `transport`, and
/// what to do about it, in a sentence or two for a person: by what is `published` in the system, a
/// topic's type beside its name. Topics below `node` (its name) are its own.
std::string explainSilence(const std::string& topic, const std::string& transport,
                           const ros::master::V_TopicInfo& published, const std::string& node);

/// The same by what the master tells; it must not be asked by a thread that may not wait.
std::string explainSilence(const std::string& topic, const std::string& transport);

}  // namespace place_recognition
