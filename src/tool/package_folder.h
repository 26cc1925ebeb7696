#pragma once

#include <string>

namespace place_recognition::tool {

/// The folder `name` (config, label_page) of the installed package beside this program, or of the
/// source tree.
std::string packageFolder(const std::string& name);

}  // namespace place_recognition::tool
