#include "tool/other_runs.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "tool/verb.h"

namespace place_recognition::tool {
namespace {

namespace fs = std::filesystem;

/// Without links and a final slash; empty for what cannot be found, which is reported when it is
/// opened.
fs::path canonical(const std::string& path) {
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(path, ignored);
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Whether `path` is `folder`, or in it.
bool contains(const fs::path& folder, const fs::path& path) {
  return !folder.empty() &&
         std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
             folder.end();
}

}  // namespace

void requireOtherRuns(const std::vector<std::string>& validate,
                      const std::vector<std::string>& learned) {
  for (const std::string& run : validate) {
    for (const std::string& other : learned) {
      if (!contains(canonical(run), canonical(other)) &&
          !contains(canonical(other), canonical(run)))
        continue;
      throw UsageError("--validate: " + run + " is also learned; give another run");
    }
  }
}

}  // namespace place_recognition::tool
