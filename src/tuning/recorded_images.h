#pragma once

#include <cstdint>
#include <string>

#include "place_recognition/progress.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// What the recordings of a search hold.
struct RecordedImages {
  std::uint64_t labelled = 0;
  std::string digest;  ///< SHA-256 of all frames, wherever their files lie
};

/// Reads the recordings from start to end. Throws Error if one is damaged, Cancelled.
RecordedImages lookThrough(const TuningRecordings& recordings, const Progress& progress);

}  // namespace place_recognition
