#pragma once

#include <string>

#include "place_recognition/part.h"

namespace place_recognition::tool {

/// The part that `--part K/N` names. Throws UsageError.
Part parsePart(const std::string& text);

}  // namespace place_recognition::tool
