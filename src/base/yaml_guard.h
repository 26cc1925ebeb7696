#pragma once

#include <string>

namespace place_recognition {

/// Throws Error, naming `where`, if YAML text nests deeper than any configuration does or repeats
/// itself through aliases, by which a few kilobytes become gigabytes once they are read; throws
/// YAML::Exception if it is no YAML. Needs no more memory than the text.
void requireModestYaml(const std::string& text, const std::string& where);

}  // namespace place_recognition
