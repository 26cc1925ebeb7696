#pragma once

#include <string>

namespace place_recognition {

/// Throws Error, naming `where`, if YAML text is nested deeper than any configuration, or repeats
/// itself through aliases, which can expand a few kilobytes to gigabytes. Throws YAML::Exception if
/// it is not YAML. Needs no more memory than the text.
void requireModestYaml(const std::string& text, const std::string& where);

}  // namespace place_recognition
