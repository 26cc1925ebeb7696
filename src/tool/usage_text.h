#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace place_recognition::tool {

using Words = std::vector<std::string>;

/// "a, b or c". `choices` must not be empty.
std::string orList(const Words& choices);

/// Prints a name and its meaning side by side, in lines of 96 columns.
void printRow(const std::string& name, const std::string& meaning, std::ostream& out);

}  // namespace place_recognition::tool
