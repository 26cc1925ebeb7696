#pragma once

#include <string>

#include "place_recognition/part.h"

namespace place_recognition::tool {

/// The part given by `--part K/N`. Throws UsageError if it is not of that form.
Part parsePart(const std::string& text);

}  // namespace place_recognition::tool
