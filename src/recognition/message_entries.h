#pragma once

#include <string_view>

namespace place_recognition {

/// Whether `payload`, of less than 2 GB, is built like a serialised proto::Model whose repeated
/// texts and messages have few enough entries to be parsed. An empty one takes two bytes in a file
/// and a hundred in memory, so they are counted before anything is allocated for them.
bool hasFewEntries(std::string_view payload);

}  // namespace place_recognition
