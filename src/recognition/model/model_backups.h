#pragma once

#include <string>
#include <string_view>

namespace place_recognition {

/// Writes `bytes` atomically to `path`, where what was there becomes the newest backup (see
/// backupPath()) and the backups one older. Writers of one folder wait for each other, so of two at
/// once each keeps the other's file. Throws Error, leaving the old file, if the disk refuses.
void replaceKeepingBackups(const std::string& path, std::string_view bytes);

}  // namespace place_recognition
