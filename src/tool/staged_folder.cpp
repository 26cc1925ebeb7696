#include "tool/staged_folder.h"

#include <cstdlib>
#include <system_error>

#include "place_recognition/error.h"

namespace place_recognition::tool {

namespace fs = std::filesystem;

StagedFolder::StagedFolder(const std::string& target) : target_(target) {
  if (fs::exists(target_) && !(fs::is_directory(target_) && fs::is_empty(target_))) {
    throw Error(target + " already exists; remove it or choose another folder.");
  }
  std::string pattern = target + ".tmp-XXXXXX";
  if (!mkdtemp(pattern.data())) {
    throw Error("Cannot write " + target + "; choose a writable folder.");
  }
  path_ = pattern;
  fs::permissions(path_, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                             fs::perms::others_read | fs::perms::others_exec);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void StagedFolder::commit() {
  fs::rename(path_, target_);
  path_.clear();
}

}  // namespace place_recognition::tool
