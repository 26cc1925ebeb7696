#pragma once

#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "place_recognition/training.h"

namespace place_recognition::tool {

/// Throws UsageError if one of the runs to validate on is among the `learned` ones, in one of them,
/// or contains one.
void requireOtherRuns(const std::vector<std::string>& validate,
                      const std::vector<std::string>& learned);

/// Throws Error if `model`, which the user knows by `name`, was trained on one of the runs to
/// validate on.
void requireNotLearned(const Model& model, const std::string& name,
                       const std::vector<RecordingOpener>& validate);

}  // namespace place_recognition::tool
