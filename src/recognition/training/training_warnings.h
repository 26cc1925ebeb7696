#pragma once

#include <string>
#include <vector>

#include "place_recognition/model.h"
#include "recognition/model/scores.h"
#include "recognition/training/samples.h"

namespace place_recognition {

// Sentences for a person about what a training cannot do well. Each function adds to `warnings`.

/// Places that cross-validation in `folds` cannot judge.
void warnOfFewImages(const Samples& samples, int folds, std::vector<std::string>& warnings);

/// Pairs of places of which more than a tenth is mistaken, beyond a standard error.
void warnOfConfusedPairs(const std::vector<ConfusedPair>& pairs,
                         const std::vector<std::string>& places,
                         std::vector<std::string>& warnings);

/// The runs of `samples` that `model`, which is extended, was trained on.
void warnOfLearnedRuns(const Model& model, const Samples& samples,
                       std::vector<std::string>& warnings);

/// A run, given its name and sketch, that judges `model` although it was trained on it.
void warnOfLearnedTest(const Model& model, const std::string& run, const RunSketch& sketch,
                       std::vector<std::string>& warnings);

/// A limit that leaves less than half of the vectors of `model`, by which its held-out frames were
/// judged. 0: no limit.
void warnOfTightLimit(const Model& model, int vector_limit, std::vector<std::string>& warnings);

}  // namespace place_recognition
