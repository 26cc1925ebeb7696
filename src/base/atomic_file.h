#pragma once

#include <string>
#include <string_view>

namespace place_recognition {

/// Writes `bytes` to `path` so that at any moment, also after kill -9 or a power cut, the file is
/// the old one or the new one, whole: temporary file in the same folder, fsync, rename, fsync of
/// the folder. Throws Error, leaving the old file and no temporary one, if the disk refuses.
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// The bytes of a file. Throws Error if it cannot be read or is longer than `limit` bytes.
std::string readFile(const std::string& path, std::size_t limit);

}  // namespace place_recognition
