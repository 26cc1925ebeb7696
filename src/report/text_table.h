#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// Cells of a table, row by row.
using TextRows = std::vector<std::vector<std::string>>;

/// Rows of cells as aligned columns, two spaces apart: the first column is left-aligned, the others
/// right-aligned. Rows may differ in length. Widths count characters of UTF-8 text.
std::string alignColumns(const TextRows& rows);

/// A, B, ..., Z, AA, AB, ...: short names for columns.
std::string columnName(std::size_t index);

/// The last part of a path.
std::string baseName(const std::string& path);

}  // namespace place_recognition
