#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace place_recognition {

/// Writes `bytes` to `path` so that at any moment, even after kill -9 or a power cut, the file is
/// either the complete old one or the complete new one: temporary file in the same folder, fsync,
/// rename, fsync of the folder. `before_rename` is called when only the rename is left. If writing
/// fails, throws Error, keeps the old file and leaves no temporary one. A link at `path` is kept,
/// and its target is written. Devices, pipes, and standard output by its name in /dev are written
/// directly.
void writeFileAtomically(const std::string& path, std::string_view bytes,
                         const std::function<void()>& before_rename = {});

/// The path that a write to `path` reaches: `path` itself or, if it is a link, its final target,
/// whether that file exists or not. Throws Error if its links lead in a circle.
std::string behindLinks(const std::string& path);

/// Removes the temporary files of killed writers of `path`. Nobody may be writing to it.
void removeLeftovers(const std::string& path);

/// The files and folders whose paths start with `start`, in its folder only.
std::vector<std::filesystem::path> pathsStartingWith(const std::filesystem::path& start);

/// Reads a file. Throws Error if it cannot be read or is longer than `limit` bytes.
std::string readFile(const std::string& path, std::size_t limit);

}  // namespace place_recognition
