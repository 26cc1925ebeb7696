#pragma once

#include <string>

namespace place_recognition {

/// An advisory lock on a folder. It leaves no file behind, and the system releases it when its
/// holder dies. It is not held if the folder cannot be opened or the file system has no locks.
class FolderLock {
 public:
  enum class IfTaken { kWait, kGiveUp };

  /// An empty `folder` means the current one.
  FolderLock(const std::string& folder, IfTaken if_taken);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool isHeld() const { return held_; }
  /// Whether another process holds it.
  bool isTaken() const { return taken_; }

 private:
  int fd_;
  bool held_ = false;
  bool taken_ = false;
};

}  // namespace place_recognition
