#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/require.h"
#include "model.pb.h"
#include "place_recognition/model.h"

namespace place_recognition {

/// Writes the properties of the training data that recognition uses: colours, held-out frames,
/// adjoining rooms, images and cameras.
void writeTrainingData(const Model& model, proto::Model& message);

/// Reads them for the places and cues of `model`. Throws Error like fromMessage().
void readTrainingData(const proto::Model& message, Model& model);

inline bool isFraction(double number) { return number >= 0 && number <= 1; }

template <typename Numbers>
void requireFinite(const Numbers& numbers, const char* otherwise) {
  for (const double number : numbers) require(std::isfinite(number), otherwise);
}

/// The texts, each followed by a zero byte.
std::string joined(const std::vector<std::string>& texts);

/// Splits the result of joined(); throws Error if there are more than `most` texts.
std::vector<std::string> separated(const std::string& bytes, std::size_t most);

}  // namespace place_recognition
