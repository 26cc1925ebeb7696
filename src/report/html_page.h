#pragma once

#include <string>

#include "report/text_table.h"

namespace place_recognition {

/// A self-contained HTML page in the common style of all reports. `body` is markup.
std::string htmlPage(const std::string& title, const std::string& body);

/// A JPEG embedded in the page, `width` pixels wide; `caption` is markup.
std::string htmlImage(const std::string& jpeg, int width, const std::string& caption);

/// Rows of plain text as a table; the first row is its header.
std::string htmlTable(const TextRows& rows);

}  // namespace place_recognition
