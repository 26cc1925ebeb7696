#pragma once

#include <string>

#include "place_recognition/model.h"
#include "place_recognition/recording.h"

namespace place_recognition {

/// Identifies a recording by its first frame with an image, see Provenance::fingerprints.
std::string fingerprintOf(const Frame& first);

/// Whether a model was trained on the run with this name and fingerprint. The name counts only if a
/// fingerprint is unknown, in whatever way its path is written; relative paths start at the current
/// folder.
bool isTrainedOn(const Provenance& provenance, const std::string& input,
                 const std::string& fingerprint);

/// The same for a recording that has not been read from; reads up to its first image.
bool isTrainedOn(const Model& model, Recording& recording);

}  // namespace place_recognition
