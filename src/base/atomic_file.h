#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace place_recognition {

/// Writes `bytes` to `path` so that at any moment, also after kill -9 or a power cut, the file is
/// the old one or the new one, whole: temporary file in the same folder, fsync, rename, fsync of
/// the folder. `before_rename` is called when nothing but the rename is left to do. Throws Error,
/// leaving the old file and no temporary one, if the disk refuses. A link at `path` stays: what it
/// leads to is written. A device or a pipe, and the standard output by its name in /dev, is written
/// into.
void writeFileAtomically(const std::string& path, std::string_view bytes,
                         const std::function<void()>& before_rename = {});

/// Where a write to `path` goes: there, or if it is a link, to where that leads in the end, whether
/// there is a file or not.
std::string behindLinks(const std::string& path);

/// Removes the temporary files of writers of `path` that were killed. Nobody may be writing to it.
void removeLeftovers(const std::string& path);

/// The bytes of a file. Throws Error if it cannot be read or is longer than `limit` bytes.
std::string readFile(const std::string& path, std::size_t limit);

}  // namespace place_recognition
