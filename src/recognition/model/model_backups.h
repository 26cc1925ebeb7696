#pragma once

#include <string>
#include <string_view>

namespace place_recognition {

/// Writes `bytes` atomically to `path`; the previous file becomes the newest backup (see
/// backupPath()), and older backups move on by one. Writers to one folder wait for each other, so
/// that each keeps the other's file as a backup. Throws Error, keeping the old file, if writing
/// fails.
void replaceKeepingBackups(const std::string& path, std::string_view bytes);

}  // namespace place_recognition
