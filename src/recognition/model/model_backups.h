#pragma once

#include <string>
#include <string_view>

namespace place_recognition {

/// Writes `bytes` atomically to `path`; the previous file becomes the newest backup (see
/// backupPath()), and older backups move on by one. Writers to one folder wait for each other, so
/// that each keeps the other's file as a backup. Throws Error, keeping the old file, if writing
/// fails.
void replaceKeepingBackups(const std::string& path, std::string_view bytes);

/// Puts the backup of this age, which must exist, in place of the file at `path`, which becomes the
/// newest backup: no version is lost, and none is kept twice. Throws Error, keeping both, if the
/// backup cannot be loaded or writing fails.
void restoreBackup(const std::string& path, int age);

}  // namespace place_recognition
