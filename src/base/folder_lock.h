#pragma once

#include <string>

namespace place_recognition {

/// Holds a folder for one holder among those who ask so. No file is left behind, and the system
/// lets go of it when its holder dies. Not held where the folder cannot be opened, or where the
/// file system knows no locks.
class FolderLock {
 public:
  enum class IfTaken { kWait, kGiveUp };

  /// An empty `folder` is the current one.
  FolderLock(const std::string& folder, IfTaken if_taken);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool isHeld() const { return held_; }
  /// Whether somebody else holds it.
  bool isTaken() const { return taken_; }

 private:
  int fd_;
  bool held_ = false;
  bool taken_ = false;
};

}  // namespace place_recognition
