#pragma once

#include <string>
#include <vector>

#include "model.pb.h"
#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// The kind of vectors that an extractor of these options gives.
proto::Vectors::Kind vectorKind(const FeatureOptions& options);

/// The support vectors of one classifier as a message; all of the given kind.
proto::Vectors toMessage(const std::vector<Feature>& features, proto::Vectors::Kind kind);

/// The support vectors in `message`. Throws Error, a sentence without a source, if its sizes,
/// indices or values are not those of vectors of the given kind.
std::vector<Feature> fromMessage(const proto::Vectors& message, proto::Vectors::Kind kind);

}  // namespace place_recognition
