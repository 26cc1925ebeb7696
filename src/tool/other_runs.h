#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/progress.h"
#include "place_recognition/training.h"

namespace place_recognition::tool {

/// Throws UsageError if one of the runs to validate on is among the `learned` ones, in one of them,
/// or contains one.
void requireOtherRuns(const std::vector<std::string>& validate,
                      const std::vector<std::string>& learned);

/// Throws Error if `model`, which the user knows by `name`, was trained on one of the runs to
/// validate on, given their names and sketches.
void requireNotLearned(const Model& model, const std::string& name,
                       const std::vector<std::string>& runs,
                       const std::vector<RunSketch>& sketches);

/// The runs of --validate, which are read for their sketches as soon as these are needed.
class ValidationRuns {
 public:
  ValidationRuns(std::vector<RecordingOpener> openers, Progress progress)
      : openers_(std::move(openers)), progress_(std::move(progress)) {}

  const std::vector<RecordingOpener>& openers() const { return openers_; }

  /// Throws Error if `model`, which the user knows by `name`, was trained on one of the runs.
  void requireNotLearnedBy(const Model& model, const std::string& name);

  /// Throws Error if one of the runs is among those that are being learned, see AfterReading.
  void requireNotAmong(const std::vector<RunSketch>& learned, const LevelRange& levels);

 private:
  /// Reads the runs, unless they were read like this before.
  void read(const LevelRange& levels);

  std::vector<RecordingOpener> openers_;
  Progress progress_;
  std::vector<std::string> names_;
  std::vector<RunSketch> sketches_;
  std::optional<LevelRange> levels_;  // by which the runs were read
  bool has_levels_ = false;           // it matters: some images have 16 bits
};

}  // namespace place_recognition::tool
