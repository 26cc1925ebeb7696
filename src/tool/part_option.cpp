#include "tool/part_option.h"

#include <cstdio>

#include "tool/command_line.h"

namespace place_recognition::tool {

Part parsePart(const std::string& text) {
  Part part;
  char rest = 0;
  const bool two = std::sscanf(text.c_str(), "%d/%d%c", &part.number, &part.count, &rest) == 2;
  if (!two || part.number < 1 || part.count < part.number) {
    throw UsageError("--part: '" + text + "' is not of the form 3/21");
  }
  return part;
}

}  // namespace place_recognition::tool
