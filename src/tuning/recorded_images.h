#pragma once

#include <cstdint>
#include <string>

#include "place_recognition/progress.h"
#include "tuning/tuning_samples.h"

namespace place_recognition {

/// The contents of the recordings of a search.
struct RecordedImages {
  std::uint64_t labelled = 0;
  std::string digest;  ///< SHA-256 of all frames, independent of file paths
};

/// Reads all recordings. Throws Error if one is damaged, or if one that is held out shows a place
/// that the others do not, or mostly their images; Cancelled if `progress` requests it.
RecordedImages lookThrough(const TuningRecordings& recordings, const Progress& progress);

}  // namespace place_recognition
