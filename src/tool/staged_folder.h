#pragma once

#include <filesystem>
#include <string>

namespace place_recognition::tool {

/// A folder that gets its name only once it is complete. Until then it is a hidden temporary folder
/// beside it, which is removed unless commit() is called. If the program is killed, the next
/// StagedFolder of this name removes it.
class StagedFolder {
 public:
  /// Throws Error if `target` exists and is not empty, or its parent cannot be written to.
  explicit StagedFolder(const std::string& target);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// The temporary folder, to be filled by the caller.
  const std::filesystem::path& path() const { return path_; }

  /// Gives the folder its name.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
};

}  // namespace place_recognition::tool
