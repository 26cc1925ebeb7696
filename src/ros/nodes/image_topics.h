#pragma once

#include <ros/master.h>

#include <string>

namespace place_recognition {

/// Explains why no image may arrive on `topic` (without /compressed) with the image transport
/// `transport`, and what to do: one or two sentences for a person, based on the `published` topics
/// of the system and their types. Topics below `node` (its name) are its own.
std::string explainSilence(const std::string& topic, const std::string& transport,
                           const ros::master::V_TopicInfo& published, const std::string& node);

/// The same based on the master's answer; the calling thread must be allowed to wait.
std::string explainSilence(const std::string& topic, const std::string& transport);

}  // namespace place_recognition
