#include "tool/other_runs.h"

#include <filesystem>
#include <memory>
#include <system_error>

#include "base/confined_path.h"
#include "place_recognition/error.h"
#include "recognition/frames/image_hash.h"
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
                       const std::vector<std::string>& runs,
                       const std::vector<RunSketch>& sketches) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!isLearned(sketches[i], model.provenance.sketches)) continue;
    throw Error("--validate: " + name + " was trained on " + runs[i] + "; give another run.");
  }
}

void ValidationRuns::requireNotLearnedBy(const Model& model, const std::string& name) {
  read(model.images.levels);
  requireNotLearned(model, name, names_, sketches_);
}

void ValidationRuns::requireNotAmong(const std::vector<RunSketch>& learned,
                                     const LevelRange& levels) {
  read(levels);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!isLearned(sketches_[i], learned)) continue;
    throw Error("--validate: most images of " + names_[i] + " are also learned; give another run.");
  }
}

void ValidationRuns::read(const LevelRange& levels) {
  const bool same = levels_ && levels_->low == levels.low && levels_->high == levels.high;
  if (same || (levels_ && !has_levels_)) return;
  names_.clear();
  sketches_.clear();
  levels_ = levels;
  for (const RecordingOpener& open : openers_) {
    const std::unique_ptr<Recording> run = open();
    run->setLevelRange(levels);
    const std::string stage = "Comparing " + run->name();
    names_.push_back(run->name());
    sketches_.emplace_back();
    for (Frame frame; run->next(frame); report(progress_, stage, run->fraction())) {
      addLabelled(frame, sketches_.back());
    }
    has_levels_ = has_levels_ || run->levelRange().known();
  }
}

}  // namespace place_recognition::tool
