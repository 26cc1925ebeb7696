#include "tool/package_folder.h"

#include <filesystem>

namespace place_recognition::tool {

namespace fs = std::filesystem;

std::string packageFolder(const std::string& name) {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path prefix = program.parent_path().parent_path().parent_path();
  const fs::path installed = prefix / "share/place_recognition" / name;
  const fs::path source = fs::path(PLACE_RECOGNITION_SOURCE) / name;
  return (fs::is_directory(installed, failure) ? installed : source).string();
}

}  // namespace place_recognition::tool
