#include "tool/package_folder.h"

#include <filesystem>

namespace place_recognition::tool {

namespace fs = std::filesystem;

std::string packageFolder(const std::string& name) {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path above = program.parent_path().parent_path();
  for (const fs::path& prefix :
       {above, above.parent_path()}) {  // of bin/ and lib/place_recognition/
    const fs::path installed = prefix / "share/place_recognition" / name;
    if (fs::is_directory(installed, failure)) return installed.string();
  }
  return (fs::path(PLACE_RECOGNITION_SOURCE) / name).string();
}

}  // namespace place_recognition::tool
