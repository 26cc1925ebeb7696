#pragma once

#include <string>

namespace place_recognition {

/// Whether the bag has the name of a recording that is still running, or whose recorder was killed.
bool isActiveBag(const std::string& path);

/// Whether `path` is named like a bag: it ends in .bag or, during recording, .bag.active, in upper
/// or lower case.
bool hasBagName(const std::string& path);

/// How to complete an active bag that a killed recorder has left behind; a phrase that follows
/// "run: ", without a full stop.
std::string howToRepair(const std::string& path);

/// What is wrong with an active bag at `path` that has no index, and what to do; a phrase that
/// follows "PATH: ", without a full stop.
std::string whyActive(const std::string& path);

/// What is wrong with the name of an active bag that is complete, and what to do; a phrase
/// without a full stop.
std::string whyMisnamed(const std::string& path);

/// The bag that is probably meant by `path`, which does not exist: the active bag of that name, or
/// a bag whose ending was left out, and what to do. A phrase that follows "; ", without a full
/// stop; empty if there is none.
std::string bagBeside(const std::string& path);

}  // namespace place_recognition
