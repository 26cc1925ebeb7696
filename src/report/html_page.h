#pragma once

#include <string>

#include "report/text_table.h"

namespace place_recognition {

/// A whole HTML page that needs no other file, in the look of all reports. `body` is markup.
std::string htmlPage(const std::string& title, const std::string& body);

/// A JPEG in the page itself, `width` pixels wide; `caption` is markup.
std::string htmlImage(const std::string& jpeg, int width, const std::string& caption);

/// Rows of plain text as a table, the first one as its head.
std::string htmlTable(const TextRows& rows);

}  // namespace place_recognition
