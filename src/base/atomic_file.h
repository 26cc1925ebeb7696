#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace place_recognition {

/// Writes `bytes` to `path` so that at any moment, also after kill -9 or a power cut, the file is
/// the old one or the new one, whole: temporary file in the same folder, fsync, rename, fsync of
/// the folder. `before_rename` is called when nothing but the rename is left to do. Throws Error,
/// leaving the old file and no temporary one, if the disk refuses. A device or a pipe at `path` is
/// written to.
void writeFileAtomically(const std::string& path, std::string_view bytes,
                         const std::function<void()>& before_rename = {});

/// Removes the temporary files of writers of `path` that were killed. Nobody may be writing to it.
void removeLeftovers(const std::string& path);

/// The bytes of a file. Throws Error if it cannot be read or is longer than `limit` bytes.
std::string readFile(const std::string& path, std::size_t limit);

}  // namespace place_recognition
