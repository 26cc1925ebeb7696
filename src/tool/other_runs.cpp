#include "tool/other_runs.h"

#include <filesystem>
#include <memory>
#include <system_error>

#include "base/confined_path.h"
#include "place_recognition/error.h"
#include "recognition/training/learned_runs.h"
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

}  // namespace

void requireOtherRuns(const std::vector<std::string>& validate,
                      const std::vector<std::string>& learned) {
  for (const std::string& run : validate) {
    for (const std::string& other : learned) {
      if (!liesIn(canonical(other), canonical(run)) && !liesIn(canonical(run), canonical(other))) {
        continue;
      }
      throw UsageError("--validate: " + run + " is also learned; give another run");
    }
  }
}

void requireNotLearned(const Model& model, const std::string& name,
                       const std::vector<RecordingOpener>& validate) {
  for (const RecordingOpener& open : validate) {
    const std::unique_ptr<Recording> run = open();
    if (!isTrainedOn(model, *run)) continue;
    throw Error("--validate: " + name + " was trained on " + run->name() + "; give another run.");
  }
}

}  // namespace place_recognition::tool
