#include "recognition/model/model_backups.h"

#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"
#include "base/folder_lock.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "recognition/model/model_container.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// Makes the file at `path` its newest backup as well, and moves the older backups on by one, with
/// renames and a hard link: if this is interrupted at any point, `path` is untouched and each
/// backup is complete. If the newest backup is already the same file, because a writer was killed
/// after this step, there is nothing to do. Failures are ignored, because none is worth losing a
/// training for. Returns whether the backups have moved on; a backup older than `oldest` is lost.
bool keepBackup(const std::string& path, int oldest = kModelBackups) {
  std::error_code ignored;
  if (!fs::exists(path, ignored) || fs::equivalent(path, backupPath(path, 1), ignored)) {
    return false;
  }
  for (int age = oldest; age > 1; --age) {
    fs::rename(backupPath(path, age - 1), backupPath(path, age), ignored);
  }
  std::error_code no_link;
  fs::create_hard_link(behindLinks(path), backupPath(path, 1), no_link);
  if (!no_link) return true;
  try {
    writeFileAtomically(backupPath(path, 1), readFile(path, kMaxModelBytes));
  } catch (const Error&) {
  }
  return true;
}

/// Removes the backup of this age; older ones close the gap.
void dropBackup(const std::string& path, int age) {
  std::error_code ignored;
  fs::remove(backupPath(path, age), ignored);
  for (; age <= kModelBackups; ++age) {
    fs::rename(backupPath(path, age + 1), backupPath(path, age), ignored);
  }
}

}  // namespace

std::string backupPath(const std::string& path, int age) {
  return path + "." + std::to_string(age);
}

void replaceKeepingBackups(const std::string& path, std::string_view bytes) {
  const FolderLock lock(fs::path(path).parent_path(), FolderLock::IfTaken::kWait);
  if (lock.isHeld()) removeLeftovers(behindLinks(path));
  writeFileAtomically(path, bytes, [&path] { keepBackup(path); });
}

void restoreBackup(const std::string& path, int age) {
  const FolderLock lock(fs::path(path).parent_path(), FolderLock::IfTaken::kWait);
  if (lock.isHeld()) removeLeftovers(behindLinks(path));
  const std::string backup = backupPath(path, age);
  const std::string bytes = readFile(backup, kMaxModelBytes);
  parseModel(bytes, backup);
  bool moved_on = false;
  // One backup more than usual is kept until the one restored is left out of the row.
  writeFileAtomically(path, bytes, [&] { moved_on = keepBackup(path, kModelBackups + 1); });
  dropBackup(path, moved_on ? age + 1 : age);
}

}  // namespace place_recognition
